"""See the settings that a camera has, change two of them, and put all back.

In one terminal:  uav-camera-server
In another one:   python change_settings.py
"""
from UAV.mavlink import MAVCom
from UAV.script import run


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)

        settings = await camera.settings.load()         # a table that follows the camera
        print(settings)
        print(await settings.set(CAM_WBMODE='Cloudy'))
        print(await settings.set(CAM_EV=1.5))
        print(await settings.set(CAM_EV=99))         # it says what is wrong
        print('exposure compensation:', settings.text('CAM_EV'))
        print(await camera.reset())
        if await settings.until(lambda now: now['CAM_EV'] == 0, timeout=10): print('all is as it was')


if __name__ == '__main__': run(main)
