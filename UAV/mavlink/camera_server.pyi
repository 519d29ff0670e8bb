"Put any camera object on MAVLink: ground stations find it, ask how it is, and take pictures with it."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import CameraInformation
from UAV.logging import LogLevels as LogLevels
from UAV.mavlink.camera_parameters import Pending
from UAV.mavlink.camera_vehicle import Geotagger
from UAV.mavlink.ftp_server import FtpServer
from UAV.mavlink.handlers import Outcome
from UAV.mavlink.health import DeviceServer, Health
from UAV.utils.file_tree import FileTree
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from typing import Any, TypeVar
_T = TypeVar('_T')

CAMERA_INFORMATION: int
CAMERA_SETTINGS: int
STORAGE_INFORMATION: int
CAMERA_CAPTURE_STATUS: int
CAMERA_IMAGE_CAPTURED: int
VIDEO_STREAM_INFORMATION: int
VIDEO_STREAM_STATUS: int
NAN: float

class FakeCamera:
    "A camera that can only say what it would be"
    information: CameraInformation
def checked_camera(camera: _T) -> _T:
    """`camera`; raises `TypeError` when it is none

    Args:
        camera: An object to serve
    """

class CameraServer(DeviceServer):
    "Serves a camera object as a MAVLink camera"
    greet_again: float
    most_peers: int
    pair: float
    at_close: list
    results: dict
    flag_tests: dict
    events: dict
    with_each_beat: list
    asks_autopilot: bool
    asked_rates: dict
    camera: Any
    guard: Any
    video_host: str | None
    health: Health
    def __init__(
            self, source_component: int = ..., mav_type: int = ..., camera: Any = None, loglevel: int = ...,
            guard: Any = None, video_host: str | None = None,
    ) -> None:
        """
        Args:
            source_component: 100 to 105 are what QGroundControl and ArduPilot look for
            camera: A Camera, or any object with `information` and some of its verbs
            guard: Who may destroy: `None`: all; `'signed'`; systems or addresses; a function of the command
            video_host: Where viewers find our streams; `None`: where each of them reaches us
        """
    def close(self) -> None:
        "Stop taking pictures, and leave the link; the camera stays open"
    def run_command(self, handler: Any, msg: Any) -> Outcome:
        "As every component does, but nothing destroys without a look at the guard"
    def for_us(self, camera_id: int) -> None:
        "Raise `Denied` when a command names another camera: we are 0 (all), or our component id"
    def check_guard(self, msg: Any) -> None:
        "Raise `Denied` when the sender of the command `msg` may not destroy"
    @property
    def flags(self) -> int:
        "CAMERA_CAP_FLAGS of what the camera object can do"
    def serve_definition(self) -> tuple:
        "Version and URI of the definition file, which is there from now on; `(0, '')` for a camera without settings"
    def send_requested(self, msg_id: int, values: Any, msg: Any, to_all: bool = False) -> None:
        "As every component does; who asks what we are, and has been away, is greeted"
    def url_of(self, picture: Any) -> str:
        "The URL of a picture; only its name when it is not offered"
    def beat(self) -> None:
        "Our heartbeat; when the camera has stopped working, or works again, it says so"
    def host_for(self, way: tuple | None = None) -> str:
        """The address under which another side finds our streams

        Args:
            way: `(channel, peer)` by which it is heard; `None`: not known
        """
    def video_streams(self, stream_id: int = 0) -> list:
        """Streams of the camera; raises `Unsupported` when it has none, `Denied` when there is no such one

        Args:
            stream_id: 0: all
        """
    @property
    def geotagger(self) -> Geotagger:
        "Knows where the camera was"
    def is_our_autopilot(self, source: tuple) -> bool:
        "Is this component the autopilot of our system?"
    @property
    def our_autopilot(self) -> tuple | None:
        "The autopilot that we believe: component 1, else the one of our system that was heard first; `None`: no heartbeat"
    def check_trigger(self, msg: Any, camera_id: int, shutter: float, begins: bool) -> None:
        """Raise `Denied` when a command is for another camera, for the autopilot, or makes no sense

        Args:
            msg: The command
            camera_id: The camera that it names; 0: all
            shutter: How long it is to be open; we leave it as it is
            begins: Is it to begin something?
        """
    @property
    def ftp(self) -> FtpServer:
        "The server's `FtpServer`"
    @property
    def files(self) -> FileTree:
        "What the server offers; `/media` is the storage of its camera"
    def media_path(self, storage_id: int = 1) -> str:
        """Where a storage stands in `files`

        Args:
            storage_id: As in STORAGE_INFORMATION
        """
    def mount_media(self, writable: bool = False) -> None:
        """Offer the folders of the camera's storages

        Args:
            writable: May clients remove pictures? The server's `guard` is asked each time
        """
    @property
    def parameters(self) -> Any:
        "The camera's `Parameters`; empty when it has none"
    def on_param_ext_request_read(self, msg: Any) -> None:
        "Answer PARAM_EXT_REQUEST_READ with a PARAM_EXT_VALUE"
    def on_param_ext_request_list(self, msg: Any) -> None:
        "Answer PARAM_EXT_REQUEST_LIST with a PARAM_EXT_VALUE for each parameter, at our pace"
    @property
    def pending(self) -> Pending:
        "The parameters that are being set"
    def on_param_ext_set(self, msg: Any) -> Any:
        "Answer PARAM_EXT_SET; a broadcast for a parameter that we have not is for another"

__all__ = [
    'NAN', 'FakeCamera', 'checked_camera', 'CameraServer', 'CAMERA_INFORMATION', 'CAMERA_SETTINGS',
    'STORAGE_INFORMATION', 'CAMERA_CAPTURE_STATUS', 'CAMERA_IMAGE_CAPTURED', 'VIDEO_STREAM_INFORMATION',
    'VIDEO_STREAM_STATUS', 'LogLevels', 'mavlink',
]
