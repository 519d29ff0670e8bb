"""List what lies on a camera's card, and fetch what you do not have yet into the folder `card`.

In one terminal:  uav-camera-server
In another one:   python take_pictures.py; python fetch_files.py
"""
from pathlib import Path

from UAV.mavlink import MAVCom
from UAV.script import run


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    folder = Path('card')
    folder.mkdir(exist_ok=True)
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)
        for entry in await camera.files.list('/media'):
            file = folder/entry.name
            if file.exists() and file.stat().st_size == entry.size: print(f'{entry.name}: here already')
            else:
                await camera.files.fetch(entry, to=folder)
                print(f'{entry.name}: fetched')


if __name__ == '__main__': run(main)
