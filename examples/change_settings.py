"""See the settings that a camera has, change two of them, and put all back.

In one terminal:  uav-camera-server
In another one:   python change_settings.py
"""
import sys

from UAV.mavlink import CameraClient, MAVCom, mavlink
from UAV.script import run


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER))
        cameras = await client.find_cameras(count=1, timeout=10)
        if not cameras: sys.exit(str(cameras))
        client.set_target(cameras[0].system, cameras[0].component)

        settings = await client.parameters()            # a table that follows the camera
        print(settings)
        print(await client.set_parameter(name='CAM_WBMODE', value='Cloudy'))
        print(await client.set_parameter(name='CAM_EV', value=1.5))
        print(await client.set_parameter(name='CAM_EV', value=99))         # it says what is wrong
        print('exposure compensation:', settings.text('CAM_EV'))
        print(await client.reset_camera_settings())
        if await settings.until(lambda now: now['CAM_EV'] == 0, timeout=10): print('all is as it was')


if __name__ == '__main__': run(main)
