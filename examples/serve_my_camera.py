"""Make a MAVLink camera of anything that gives pictures: here a clock, which ground stations see and photograph.

In one terminal:  python serve_my_camera.py
In another one:   python take_pictures.py, or watch_video.py       (QGroundControl needs an autopilot of this system, too)
Ctrl-C ends it. A vehicle's autopilot is at the other end of a serial port: python serve_my_camera.py /dev/serial0
"""
import threading, time

import cv2, numpy as np
from UAV.cameras import Camera, CameraInformation, Frame
from UAV.mavlink import CameraServer, MAVCom, mavlink
from UAV.script import run


class ClockCamera(Camera):
    "Sees the time of day"
    information = CameraInformation(vendor='Examples', model='ClockCamera', resolution_h=320, resolution_v=120)
    number = 0

    def read(self) -> Frame:
        "The newest frame: a BGR picture, a number that grows, and when it was taken, in s since 1970"
        self.number, now = self.number+1, time.time()
        image = np.full((120, 320, 3), 40, np.uint8)
        cv2.putText(image, time.strftime('%H:%M:%S'), (30, 80), cv2.FONT_HERSHEY_SIMPLEX, 2, (80, 220, 255), 3)
        return Frame(image, self.number, now)


def main(connection: str = 'udpout:127.0.0.1:14550') -> None:
    with ClockCamera(folder='clock_pictures') as camera, MAVCom(connection, source_system=1) as vehicle:
        vehicle.add_component(CameraServer(mavlink.MAV_COMP_ID_CAMERA, camera=camera))
        camera.add_stream('clock', port=0)          # live video, on a port that is free
        print(f'{camera.information.model} is served at 1/100 on {connection}', flush=True)
        try: threading.Event().wait()
        except KeyboardInterrupt: print(f'{len(camera.pictures)} pictures were taken')


if __name__ == '__main__': run(main)
