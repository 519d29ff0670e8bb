"""Have the camera record three seconds of video on its own disk, and fetch the film.

In one terminal:  uav-camera-server
In another one:   python record.py
"""
import sys
from pathlib import Path

from UAV.mavlink import CameraClient, MAVCom, mavlink
from UAV.script import run

STATUS = mavlink.MAVLINK_MSG_ID_CAMERA_CAPTURE_STATUS


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER))
        cameras = await client.find_cameras(count=1, timeout=10)
        if not cameras: sys.exit(str(cameras))
        client.set_target(cameras[0].system, cameras[0].component)

        try:
            with client.expecting(STATUS, lambda status: status.recording_time_ms >= 3000) as long_enough:
                print(await client.video_start_capture(frequency=4), flush=True)    # it tells four times a second
                await long_enough.wait(timeout=30)
        finally: print(await client.video_stop_capture())               # after Ctrl-C, too

        films = [file for file in await client.list_files(path='/media') if file.name.endswith('.mp4')]
        await client.download(path=f'/media/{films[-1].name}', to=Path.cwd())
        print(f'the film is in {films[-1].name}')


if __name__ == '__main__': run(main)
