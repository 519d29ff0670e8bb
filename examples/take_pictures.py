"""Take three pictures, and fetch each of them over MAVLink: they come into the folder `pictures`.

In one terminal:    uav-camera-server
In another one:     python take_pictures.py
A camera elsewhere: python take_pictures.py udpin:0.0.0.0:14550
"""
from pathlib import Path

from UAV.mavlink import MAVCom
from UAV.script import run


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    folder = Path('pictures')
    folder.mkdir(exist_ok=True)
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)
        print(f'found {camera.name} at {camera.system}/{camera.component}')
        async for picture in camera.capture(3, interval=1):
            if not picture.capture_result: print(f'picture {picture.image_index} failed')
            else:
                file = await camera.files.fetch(picture, to=folder)
                print(f'picture {picture.image_index} is in {file}')


if __name__ == '__main__': run(main)
