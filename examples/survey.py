"""Have a picture taken every 15 metres while the vehicle flies, and see where each of them was taken.

In one terminal:  uav-camera-server --gimbal sim --path circle --autopilot
In another one:   python survey.py
"""
import asyncio, sys

from UAV.mavlink import CameraClient, MAVCom, mavlink
from UAV.script import run
from UAV.utils.earth import great_circle

APART, COUNT = 15, 5        # m between two pictures; how many


async def begin(client: CameraClient) -> None:
    "A camera that has not heard its position yet refuses: we ask again"
    for attempt in range(20):
        ack = await client.do_set_cam_trigg_dist(distance=APART, trigger=True)
        if ack.result != mavlink.MAV_RESULT_TEMPORARILY_REJECTED:
            ack.check()
            return
        await asyncio.sleep(.5)
    sys.exit('The camera hears no position.')


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER))
        cameras = await client.find_cameras(count=1, timeout=10)
        if not cameras: sys.exit(str(cameras))
        client.set_target(cameras[0].system, cameras[0].component)
        last, seen = None, 0
        try:
            await begin(client)
            async for picture in client.pictures():
                here = picture.lat/1e7, picture.lon/1e7
                way = f', {great_circle(*last, *here):.0f} m from the last one' if last else ''
                print(f'{here[0]:.6f} {here[1]:.6f}{way}', flush=True)
                last, seen = here, seen+1
                if seen == COUNT: break
        finally: print(await client.do_set_cam_trigg_dist(distance=0))      # after Ctrl-C, too


if __name__ == '__main__': run(main)
