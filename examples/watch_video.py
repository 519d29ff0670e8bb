"""Watch the camera's live video for five seconds: the newest picture of each second comes into the folder `video`.

In one terminal:  uav-camera-server
In another one:   python watch_video.py
"""
import asyncio
from pathlib import Path

import cv2
from UAV.mavlink import MAVCom
from UAV.script import run


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    folder = Path('video')
    folder.mkdir(exist_ok=True)
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)
        for stream in await camera.video.streams(): print(f'{stream.name}: {stream.kind}, {stream.width}×{stream.height}')
        async with camera.video() as player:
            for second in range(5):
                frame = await anext(player)                 # the newest; those that we missed are gone
                file = folder/f'second_{second}.jpg'
                cv2.imwrite(str(file), frame.image)         # or cv2.imshow, if your OpenCV has windows
                print(file)
                await asyncio.sleep(1)


if __name__ == '__main__': run(main)
