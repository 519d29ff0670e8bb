"""Serve a camera with settings of its own, over TCP and over a serial line at the same time.

In one terminal:  python serve_settings.py tcpin:127.0.0.1:5760 /dev/ttyUSB0
In another one:   uav-camera --connection tcp:127.0.0.1:5760 set PALETTE Ice         (QGroundControl needs an autopilot, too)
Without a serial port, leave the second word out. Ctrl-C ends it.
"""
import threading, time

import cv2, numpy as np
from UAV.cameras import Camera, CameraInformation, Frame, Parameter
from UAV.mavlink import CameraServer, MAVCom
from UAV.script import run

COLOURS = {'Fire': cv2.COLORMAP_INFERNO, 'Rainbow': cv2.COLORMAP_TURBO, 'Ice': cv2.COLORMAP_WINTER}


class HeatCamera(Camera):
    "Sees a warm spot that wanders from left to right"
    information = CameraInformation(vendor='Examples', model='HeatCamera', resolution_h=320, resolution_v=240)
    declared = [Parameter('PALETTE', 'int32', cv2.COLORMAP_INFERNO, 'Colours of the temperatures', COLOURS),
                Parameter('WARMEST', 'float', 40., 'The brightest colour', low=20, high=100, step=1, unit='°C')]
    number = 0

    def read(self) -> Frame:
        "The newest frame, in the colours that are set"
        self.number, (y, x) = self.number+1, np.mgrid[:240, :320]
        celsius = 18+30*np.exp(-((x-self.number*5 % 320)**2+(y-120)**2)/800)
        shades = np.clip((celsius-18)/(self.parameters['WARMEST']-18)*255, 0, 255).astype(np.uint8)
        return Frame(cv2.applyColorMap(shades, self.parameters['PALETTE']), self.number, time.time())


def main(tcp: str = 'tcpin:127.0.0.1:5760', serial: str = '', baudrate: str = '57600') -> None:
    with HeatCamera(folder='heat_pictures') as camera, MAVCom(tcp, source_system=1) as vehicle:
        if serial: vehicle.add_link(serial, int(baudrate))
        vehicle.add_component(CameraServer(camera=camera))
        print(f'{camera.information.model} is served at 1/100 on {tcp}', serial and f'and {serial}', flush=True)
        try: threading.Event().wait()
        except KeyboardInterrupt: print('the settings at the end:', *(f'{p.name}={camera.parameters[p.name]}' for p in camera.declared))


if __name__ == '__main__': run(main)
