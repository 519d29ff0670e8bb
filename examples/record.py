"""Have the camera record three seconds of video on its own disk, and fetch the film.

In one terminal:  uav-camera-server
In another one:   python record.py
"""
from pathlib import Path

from UAV.mavlink import MAVCom, mavlink
from UAV.script import run

STATUS = mavlink.MAVLINK_MSG_ID_CAMERA_CAPTURE_STATUS


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)

        try:
            with camera.client.expecting(STATUS, lambda status: status.recording_time_ms >= 3000) as long_enough:
                print(await camera.record(frequency=4), flush=True)    # it tells four times a second
                await long_enough.wait(timeout=30)
        finally: print(await camera.stop_recording())               # after Ctrl-C, too

        films = [file for file in await camera.files.list('/media') if file.name.endswith('.mp4')]
        await camera.files.fetch(films[-1], to=Path.cwd())
        print(f'the film is in {films[-1].name}')


if __name__ == '__main__': run(main)
