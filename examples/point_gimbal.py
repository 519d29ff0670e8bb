"""Take control of a gimbal, look down, to both sides and ahead, and take a picture of each view.

In one terminal:  uav-camera-server --gimbal sim --autopilot
In another one:   python point_gimbal.py
"""
import sys

from UAV.mavlink import MAVCom
from UAV.script import run

VIEWS = {'down': (-90, 0), 'left': (-20, -60), 'right': (-20, 60), 'ahead': (-10, 0)}       # pitch and yaw, degrees


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        gimbal = await ground.find_gimbal(timeout=10)
        print(f'found {gimbal.name}')
        camera = await ground.find_camera(timeout=10)
        async with gimbal.control():
            for name, (pitch, yaw) in VIEWS.items():
                (await gimbal.set_angles(pitch=pitch, yaw=yaw)).check()
                there = await gimbal.reached(tolerance=.4)
                if there is None: sys.exit(f'The gimbal does not get to {name}.')
                async for picture in camera.capture():
                    print(f'{name}: pitch {round(there.pitch)}, yaw {round(there.yaw)}, picture {picture.image_index}')


if __name__ == '__main__': run(main)
