"""The scenarios of the first edition of this package (2023), with its names and defaults, one after the other.

Alone:                    python published.py
Over a serial cable too:  python published.py 14445 /dev/ttyUSB0 /dev/ttyUSB1      (the cable joins the two)
"""
import time

from UAV.logging import LogLevels
from UAV.mavlink import CameraClient, CameraServer, Component, MAVCom, mavlink
from UAV.script import run
from UAV.utils.display import doc_class

QUIET = LogLevels.ERROR       # the servers have no camera, and would say so


class Cam(Component):
    def __init__(self, source_component: int, mav_type: int, loglevel: int = LogLevels.INFO) -> None:
        super().__init__(source_component=source_component, mav_type=mav_type, loglevel=loglevel)
        self.append_message_handler(self.on_message)

    def on_message(self, msg: mavlink.MAVLink_message) -> bool: return True        # the command was ok: send an ack


def three_cameras(there: str) -> None:
    with MAVCom(there, source_system=222) as com:
        for number in (100, 101, 102): com.add_component(CameraServer(number, loglevel=QUIET))
        time.sleep(1)
        print('1. components:', *sorted(com.component))


def list_commands() -> None:
    print('2. what a camera can do:')
    CameraServer(loglevel=QUIET).list_commands()


async def find_camera(here: str, there: str) -> None:
    with MAVCom(here, source_system=111) as ground, MAVCom(there, source_system=222) as vehicle:
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_CAMERA, mavlink.MAV_TYPE_GCS))
        vehicle.add_component(CameraServer(22, mavlink.MAV_TYPE_CAMERA, loglevel=QUIET))
        found = await client.wait_heartbeat(remote_mav_type=mavlink.MAV_TYPE_CAMERA)
        time.sleep(1)           # the reader threads do not sleep
        msg = await client.request_message(mavlink.MAVLINK_MSG_ID_CAMERA_INFORMATION, target_system=222, target_component=22)
        print('3.', found, msg.get_type(), bytes(msg.model_name).rstrip(b'\0').decode())


async def five_commands(number: int, here: str, there: str, baudrate: int = 57600) -> None:
    with MAVCom(here, baudrate, source_system=111) as ground, MAVCom(there, baudrate, source_system=222) as vehicle:
        client = ground.add_component(Component(11, mavlink.MAV_TYPE_GCS))
        cams = [vehicle.add_component(Cam(n, mavlink.MAV_TYPE_CAMERA)) for n in (22, 23)]
        for n in (22, 23): await client.wait_heartbeat(target_system=222, target_component=n, timeout=20)
        for n in (22, 22, 23, 23, 24): await client.test_command(222, n, 1)         # there is no 24
        print(f'{number}. {client.num_cmds_sent} commands sent, {client.num_acks_rcvd} acks received, {client.num_acks_drop} missing;',
              'received by each camera:', *(cam.num_cmds_rcvd for cam in cams))


async def main(port: str = '14445', serial: str = '', other_end: str = '') -> None:
    here, there = f'udpin:localhost:{port}', f'udpout:localhost:{port}'
    three_cameras(there)
    list_commands()
    await find_camera(here, there)
    await five_commands(4, here, there)
    if serial: await five_commands(5, serial, other_end, 115200)
    print('6.', doc_class(CameraClient))


if __name__ == '__main__': run(main)
