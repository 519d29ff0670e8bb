"""`examples/serve_settings.py`, written with MAVSDK: the definition file is written by hand, and nothing forwards between the links."""
import sys, threading, time
from pathlib import Path

import cv2, numpy as np
from mavsdk import ComponentType, Configuration, Mavsdk, log_subscribe
from mavsdk.plugins.camera_server import (CameraFeedback, CameraServer, CaptureInfo, CaptureStatus, Information, Position, Quaternion,
                                          StorageInformation)
from mavsdk.plugins.ftp_server import FtpServer
from mavsdk.plugins.param_server import ParamServer

DEFINITION = '''<mavlinkcamera><definition version="1"><model>HeatCamera</model><vendor>Examples</vendor></definition><parameters>
<parameter name="PALETTE" type="int32" default="14"><description>Colours of the temperatures</description>
<options><option name="Fire" value="14"/><option name="Rainbow" value="20"/><option name="Ice" value="3"/></options></parameter>
<parameter name="WARMEST" type="float" default="40" min="20" max="100" step="1" unit="°C"><description>The brightest colour</description></parameter>
</parameters></mavlinkcamera>'''


class HeatCamera:
    number = 0

    def __init__(self, component, folder):
        self.folder, self.taken = folder, 0
        (folder/'media').mkdir(parents=True, exist_ok=True)
        (folder/'heat.xml').write_text(DEFINITION)
        self.files, self.values, self.server = FtpServer(component), ParamServer(component), CameraServer(component)
        self.files.set_root_dir(str(folder))
        self.values.provide_param_int('PALETTE', cv2.COLORMAP_INFERNO)
        self.values.provide_param_float('WARMEST', 40.)
        self.server.set_information(Information(
            vendor_name='Examples', model_name='HeatCamera', firmware_version='1.0.0.0', focal_length_mm=3., horizontal_sensor_size_mm=4.,
            vertical_sensor_size_mm=3., horizontal_resolution_px=320, vertical_resolution_px=240, lens_id=0, definition_file_version=1,
            definition_file_uri='mftp:///heat.xml', image_in_video_mode_supported=True, video_in_image_mode_supported=True))
        self.server.subscribe_take_photo(self.take_photo)
        self.server.subscribe_capture_status(self.status)
        self.server.subscribe_storage_information(self.storage)

    def image(self):
        self.number, (y, x) = self.number+1, np.mgrid[:240, :320]
        warmest = self.values.retrieve_param_float('WARMEST')
        celsius = 18+30*np.exp(-((x-self.number*5 % 320)**2+(y-120)**2)/800)
        shades = np.clip((celsius-18)/(warmest-18)*255, 0, 255).astype(np.uint8)
        return cv2.applyColorMap(shades, self.values.retrieve_param_int('PALETTE'))

    def take_photo(self, index, *_):
        name = f'media/IMG_{self.taken:06}.jpg'
        ok = cv2.imwrite(str(self.folder/name), self.image())
        feedback = CameraFeedback.OK if ok else CameraFeedback.FAILED
        self.server.respond_take_photo(feedback, CaptureInfo(
            position=Position(0, 0, 0, 0), attitude_quaternion=Quaternion(1, 0, 0, 0), time_utc_us=int(time.time()*1e6), index=self.taken,
            is_success=ok, file_url=f'mftp:///{name}'))
        self.taken += ok

    def status(self, *_):
        self.server.respond_capture_status(CameraFeedback.OK, CaptureStatus(
            image_interval_s=0., recording_time_s=0., available_capacity_mib=100., image_count=self.taken,
            image_status=CaptureStatus.ImageStatus.IDLE, video_status=CaptureStatus.VideoStatus.IDLE))

    def storage(self, *_):
        self.server.respond_storage_information(CameraFeedback.OK, StorageInformation(
            used_storage_mib=0., available_storage_mib=100., total_storage_mib=100., storage_id=1,
            storage_status=StorageInformation.StorageStatus.FORMATTED, storage_type=StorageInformation.StorageType.SD,
            read_speed_mib_s=0., write_speed_mib_s=0.))


def main(tcp='tcpin://127.0.0.1:5760', serial='', baudrate='57600'):
    log_subscribe(lambda *_: True)
    sdk = Mavsdk(Configuration.create_manual(1, 100, True))
    sdk.add_any_connection_with_handle(tcp)
    if serial: sdk.add_any_connection_with_handle(f'serial://{serial}:{baudrate}')
    camera = HeatCamera(sdk.server_component_by_type(ComponentType.CAMERA), Path('heat_pictures').absolute())
    print(f'HeatCamera is served at 1/100 on {tcp}', serial and f'and {serial}', flush=True)
    try: threading.Event().wait()
    except KeyboardInterrupt:
        print('the settings at the end:', f"PALETTE={camera.values.retrieve_param_int('PALETTE')}",
              f"WARMEST={camera.values.retrieve_param_float('WARMEST')}")
    finally: sdk.destroy()


if __name__ == '__main__': main(*sys.argv[1:])
