"""List what lies on a camera's card, and fetch what you do not have yet into the folder `card`.

In one terminal:  uav-camera-server
In another one:   python take_pictures.py; python fetch_files.py
"""
import sys
from pathlib import Path

from UAV.mavlink import CameraClient, MAVCom, mavlink
from UAV.script import run


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    folder = Path('card')
    folder.mkdir(exist_ok=True)
    with MAVCom(connection, source_system=255) as ground:
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER))
        cameras = await client.find_cameras(count=1, timeout=10)
        if not cameras: sys.exit(str(cameras))
        client.set_target(cameras[0].system, cameras[0].component)
        for entry in await client.list_files(path='/media'):
            file = folder/entry.name
            if file.exists() and file.stat().st_size == entry.size: print(f'{entry.name}: here already')
            else:
                await client.download(path=f'/media/{entry.name}', to=folder)
                print(f'{entry.name}: fetched')


if __name__ == '__main__': run(main)
