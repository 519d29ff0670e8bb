"Open what the options say, tell how it is, and close it at Ctrl-C."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.serving.status import Teller
from contextlib import ExitStack
from types import SimpleNamespace
from typing import Any

def understood(typed: Any) -> SimpleNamespace:
    """The options as values; raises `ValueError`, or `OSError` for a key that cannot be read

    Args:
        typed: Has the options of `serve_camera` as attributes
    """
def opened(typed: Any, stack: ExitStack) -> tuple:
    """Open what was typed: `(camera, MAVCom)`; raises `ValueError`, `CameraError`, `MAVError` or `OSError`

    Args:
        typed: Has the options of `serve_camera` as attributes
        stack: Closes what was opened
    """
def name_of(component: Any) -> str:
    "What a component is, for people"
def introduce(camera: Any, com: Any, teller: Teller) -> None:
    "Tell what is served, and where"
def serve(typed: Any) -> None:
    """Open what was typed, and tell how it is until Ctrl-C

    Args:
        typed: Has the options of `serve_camera` as attributes
    """
def serve_camera(
        connection: str = 'udpout:127.0.0.1:14550', camera: str = 'sim', system: int = 1, component: int = 100,
        folder: str = 'uav_pictures', quota: float | None = None, storage: str | None = None, rtsp: int = 8554,
        rtp: str | None = None, mpegts: str | None = None, tcp: int | None = None, host: str | None = None,
        codec: str = 'h264', size: str | None = None, rate: float = 15.0, bitrate: float | None = None,
        sign: str | None = None, forward: bool = False, gimbal: str | None = None, role: str = 'both',
        mounted: str | None = None, path: str | None = None, autopilot: bool = False,
) -> None:
    """Serve a camera to ground stations until Ctrl-C, with stills, video and storage. Examples:

    Args:
        connection: MAVLink links, with commas between them
        camera: sim, dual (sees heat, too), 0, /dev/video0, a video FILE, a URL, PIPELINE.toml, or 'source ! …'
        system: System id, which is the vehicle's
        component: Component id, 100 … 105
        folder: For pictures and recordings
        quota: MiB that each storage may fill; without it: the whole disk
        storage: Folders of more storages, with commas between them; `uav-camera storage` chooses
        rtsp: Port of the RTSP server; 0: a free one, -1: none
        rtp: HOST:PORT of a ground station that gets RTP
        mpegts: HOST:PORT of a viewer that gets MPEG-TS
        tcp: Port where MPEG-TS is to be had
        host: Address where viewers find us; without it: that of the interface which reaches them
        codec: h264 or h265
        size: Of the video, such as 1280x720; without it: the camera's
        rate: Pictures in a second, at most
        bitrate: Mbit/s; without it: what suits size and rate
        sign: File with the key of a signed link
        forward: Pass MAVLink on from link to link
        gimbal: sim, or viewsheen://HOST[:PORT]: a gimbal at component 154; the simulated camera hangs from sim
        role: Of the gimbal: both, or device when an autopilot manages it (ArduPilot's MNT1_TYPE 6)
        mounted: down, forward, or ROLL,PITCH,YAW in degrees: how the camera is fixed to the vehicle
        path: hover or circle: what a simulated vehicle flies, from which the gimbal hangs
        autopilot: Beat as the autopilot of that vehicle, too: QGroundControl shows no gimbal without one
    """

__all__ = ['understood', 'opened', 'name_of', 'introduce', 'serve', 'serve_camera']
