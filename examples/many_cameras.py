"""Three cameras on one vehicle take a picture at the same time: one looks down, one ahead, one far.

Vehicle and ground station are both in here, so this needs nothing else:  python many_cameras.py
The pictures are in the folder `pictures`.
"""
import asyncio
from contextlib import ExitStack

from UAV.cameras import SimCamera
from UAV.mavlink import CameraServer, MAVCom
from UAV.mavlink.camera_client import RemoteCamera
from UAV.script import run


async def shoot(camera: RemoteCamera) -> str:
    "Where the next picture of a camera is, on that camera"
    async for picture in camera.capture():
        if picture.capture_result: return str(picture.file_url)
    return 'no picture'


async def main(connection: str = 'virtual:many_cameras') -> None:
    with ExitStack() as stack:
        vehicle = stack.enter_context(MAVCom(connection, source_system=1))
        ground = stack.enter_context(MAVCom(connection, source_system=255))
        for number, (name, pitch) in enumerate({'Down': -90, 'Ahead': -15, 'Far': -8}.items()):
            camera = stack.enter_context(SimCamera(model=name, pitch=pitch, folder=f'pictures/{name}'))
            if name == 'Far': camera.set_camera_zoom('range', 40)
            vehicle.add_component(CameraServer(100+number, camera=camera))

        cameras = await ground.find_cameras(count=3, timeout=10)
        files = await asyncio.gather(*map(shoot, cameras))
        for found, file in zip(cameras, files): print(f'{found.name}: {file}')


if __name__ == '__main__': run(main)
