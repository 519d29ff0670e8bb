"""Have a picture taken every 15 metres while the vehicle flies, and see where each of them was taken.

In one terminal:  uav-camera-server --gimbal sim --path circle --autopilot
In another one:   python survey.py
"""
import asyncio, sys

from UAV.mavlink import MAVCom, mavlink
from UAV.mavlink.camera_client import RemoteCamera
from UAV.script import run
from UAV.utils.geo import great_circle

APART, COUNT = 15, 5        # m between two pictures; how many


async def begin(camera: RemoteCamera) -> None:
    "A camera that has not heard its position yet refuses: we ask again"
    for attempt in range(20):
        ack = await camera.trigger_every(metres=APART, first=True)
        if ack.result != mavlink.MAV_RESULT_TEMPORARILY_REJECTED:
            ack.check()
            return
        await asyncio.sleep(.5)
    sys.exit('The camera hears no position.')


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)
        last, seen = None, 0
        try:
            await begin(camera)
            async for picture in camera.pictures():
                here = picture.lat/1e7, picture.lon/1e7
                way = f', {great_circle(*last, *here):.0f} m from the last one' if last else ''
                print(f'{here[0]:.6f} {here[1]:.6f}{way}', flush=True)
                last, seen = here, seen+1
                if seen == COUNT: break
        finally: print(await camera.trigger_every(metres=0))      # after Ctrl-C, too


if __name__ == '__main__': run(main)
