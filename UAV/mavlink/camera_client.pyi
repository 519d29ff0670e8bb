"Find MAVLink cameras, and ask them what they are and how they are."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.pursuit import TrackingStatus
from UAV.cameras.thermal import ThermalRange
from UAV.logging import LogLevels as LogLevels
from UAV.mavlink.camera_fov import FieldOfView
from UAV.mavlink.component import Component
from UAV.mavlink.remote_parameters import ParameterAck, RemoteParameters
from UAV.mavlink.remotes import RoundTrip
from UAV.mavlink.video_client import Stream
from UAV.utils.jail import FileEntry
from UAV.video.player import Player
from UAV.wire.dialect import Ack
from UAV.wire.ftp_frames import FtpFrame
from collections.abc import AsyncGenerator
from dataclasses import dataclass
from pathlib import Path
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from typing import Any, overload

CAMERA_INFORMATION: int
CAMERA_SETTINGS: int
STORAGE_INFORMATION: int
CAMERA_CAPTURE_STATUS: int
CAMERA_IMAGE_CAPTURED: int
NAN: float

class CameraClient(Component):
    "Finds and commands MAVLink cameras"
    most_cameras: int
    last_shot: int
    first_look: float
    ftp_patience: float
    most_files: int
    upload_tries: int
    notices: dict
    def __init__(self, source_component: int, mav_type: int = ..., loglevel: int = ...) -> None:
        """
        Args:
            source_component: Our component id, for example `MAV_COMP_ID_MISSIONPLANNER` (190)
        """
    def next_shot(self) -> int:
        "A new number for a single shot, 1 to `last_shot`"
    async def request_camera_information(
            self, target_system: int | None = None, target_component: int | None = None,
    ) -> Any:
        "CAMERA_INFORMATION, or `None`"
    async def request_camera_settings(self, target_system: int | None = None, target_component: int | None = None) -> Any:
        "CAMERA_SETTINGS: mode, zoom and focus; or `None`"
    async def request_camera_capture_status(
            self, target_system: int | None = None, target_component: int | None = None,
    ) -> Any:
        "CAMERA_CAPTURE_STATUS, or `None`"
    async def request_storage_information(
            self, target_system: int | None = None, target_component: int | None = None, storage_id: int = 0,
    ) -> Any:
        """STORAGE_INFORMATION of a storage, sizes in MiB; or `None`

        Args:
            storage_id: 0: any
        """
    async def request_camera_image_capture(
            self, target_system: int | None = None, target_component: int | None = None, index: int = 0,
    ) -> Any:
        """CAMERA_IMAGE_CAPTURED of a picture once more, or `None`

        Args:
            index: Which picture, from 0
        """
    async def find_cameras(self, count: int | None = None, timeout: float = 1.5) -> list[RemoteCamera]:
        """A `RemoteCamera` for each camera that beats, ordered by address; raises `LinkError` when we are on no link

        Args:
            count: Return as soon as so many have been heard
            timeout: Seconds to listen; heartbeats come once a second
        """
    async def set_camera_mode(
            self, target_system: int | None = None, target_component: int | None = None, mode_id: int | str = ...,
    ) -> Ack:
        """Switch between taking pictures, video, and surveying

        Args:
            mode_id: A CAMERA_MODE, or its word: `'video'`
        """
    def next_step(self) -> list:
        "Parameters 4 to 7 of a step: each is 0 or NaN, and not all as in one of the 15 steps before"
    async def set_camera_zoom(
            self, target_system: int | None = None, target_component: int | None = None, zoom_type: int | str = ...,
            zoom_value: float = 1,
    ) -> Ack:
        """Zoom

        Args:
            zoom_type: A CAMERA_ZOOM_TYPE, or its word: `'range'` is %
            zoom_value: Steps, speed -1 to 1, %, mm, or degrees
        """
    async def set_camera_focus(
            self, target_system: int | None = None, target_component: int | None = None, focus_type: int | str = ...,
            focus_value: float = 1,
    ) -> Ack:
        """Focus

        Args:
            focus_type: A SET_FOCUS_TYPE, or its word: `'auto'`
            focus_value: Steps, speed -1 to 1, %, or metres
        """
    async def reset_camera_settings(self, target_system: int | None = None, target_component: int | None = None) -> Ack:
        "Put all settings back to their defaults"
    async def storage_format(
            self, target_system: int | None = None, target_component: int | None = None, storage_id: int = 1,
    ) -> Ack:
        """Delete all pictures on a storage; the camera counts from 0 again, and so do we

        Args:
            storage_id: As in STORAGE_INFORMATION
        """
    async def video_start_capture(
            self, target_system: int | None = None, target_component: int | None = None, video_stream_id: int = 0,
            frequency: float = 1,
    ) -> Ack:
        """Start recording

        Args:
            video_stream_id: 0: all
            frequency: CAMERA_CAPTURE_STATUS messages per second while recording
        """
    async def video_stop_capture(
            self, target_system: int | None = None, target_component: int | None = None, video_stream_id: int = 0,
    ) -> Ack:
        """Stop recording

        Args:
            video_stream_id: 0: all
        """
    async def video_start_streaming(
            self, target_system: int | None = None, target_component: int | None = None, video_stream_id: int = 0,
    ) -> Ack:
        """Start streaming

        Args:
            video_stream_id: 0: all
        """
    async def video_stop_streaming(
            self, target_system: int | None = None, target_component: int | None = None, video_stream_id: int = 0,
    ) -> Ack:
        """Stop streaming

        Args:
            video_stream_id: 0: all
        """
    async def request_camera_fov_status(self, target_system: int | None = None, target_component: int | None = None) -> Any:
        "CAMERA_FOV_STATUS, or `None`"
    async def fov(self, target_system: int | None = None, target_component: int | None = None) -> FieldOfView | None:
        "What the camera sees now; `None` when it does not tell"
    async def streams(self, target_system: int | None = None, target_component: int | None = None) -> list[Stream]:
        "The camera's video streams, by number; empty when it says that it has none. Raises `NoAnswer` when it is silent"
    async def watch_stream(self, target: tuple, stream: Stream, **options: Any) -> Player:
        """A `Player` of a stream, which is started if need be; raises `ValueError`, `OSError`, `MAVError`

        Args:
            target: `(system, component)` of the camera
            stream: As `streams` gave it
            options: For `Player`
        """
    async def open_stream(
            self, target_system: int | None = None, target_component: int | None = None, stream_id: int | None = None,
            name: str | None = None, **options: Any
    ) -> Player:
        """A `Player` of a stream, which is started if need be; raises `ValueError` when there is none, `MAVError`

        Args:
            stream_id: Which stream; `None`: the first, or that of the `name`
            name: Its name
            options: For `Player`
        """
    def on_image_captured(self, msg: Any) -> None:
        "Keep the notice of a picture"
    async def wait_images(
            self, target_system: int | None = None, target_component: int | None = None, count: int = 1,
            timeout: float = 5.0,
    ) -> list:
        """The next `count` CAMERA_IMAGE_CAPTURED of a camera, lost ones asked for; fewer when no more come. Raises `Lost`

        Args:
            count: How many pictures
            timeout: Seconds without a new one after which we give up
        """
    async def image_start_capture(
            self, target_system: int | None = None, target_component: int | None = None, interval: float = 0,
            count: int = 1,
    ) -> Ack:
        """Take pictures; `wait_images` gives their notices, among all (`capture` gives only your own)

        Args:
            interval: Seconds between two pictures
            count: How many; 0 is unlimited
        """
    async def image_stop_capture(self, target_system: int | None = None, target_component: int | None = None) -> Ack:
        "Stop taking pictures; a `capture` of ours that is under way ends"
    def pictures(self, target_system: int | None = None, target_component: int | None = None) -> AsyncGenerator[Any, None]:
        "For `async for`: each CAMERA_IMAGE_CAPTURED of a camera from now on, your own and others'. Raises `Lost`"
    def capture(
            self, target_system: int | None = None, target_component: int | None = None, interval: float = 0,
            count: int = 1, timeout: float = 5.0,
    ) -> AsyncGenerator[Any, None]:
        """For `async for`: the CAMERA_IMAGE_CAPTURED of each picture of yours. Raises `CommandError`, `Lost`, `NoAnswer`

        Args:
            interval: Seconds between two pictures
            count: How many; 0: until you leave the loop
            timeout: Seconds without anything new after which we give up; longer on a slow link, or when it is there
        """
    async def storages(self, target_system: int | None = None, target_component: int | None = None) -> list:
        "The camera's storages, by number; empty when it says that it has none. Raises `NoAnswer` when it is silent"
    async def set_storage_usage(
            self, target_system: int | None = None, target_component: int | None = None, storage_id: int = 1,
            usage: Any = ...,
    ) -> Ack:
        """Say what goes to a storage; it then no longer goes to the others. Raises `ValueError`

        Args:
            storage_id: As in STORAGE_INFORMATION
            usage: What is to go there: a set of 'photo' and 'video'
        """
    async def set_camera_source(
            self, target_system: int | None = None, target_component: int | None = None, primary: str = 'default',
            secondary: str = 'default',
    ) -> Ack:
        """Choose what a camera with several sources shows. Raises `ValueError`

        Args:
            primary: 'default', 'rgb', 'ir' or 'ndvi'
            secondary: The picture in the corner; 'default': none
        """
    async def thermal_range(
            self, target_system: int | None = None, target_component: int | None = None, stream_id: int = 0,
    ) -> ThermalRange | None:
        """The hottest and the coldest place in a stream; `None` when the camera does not tell

        Args:
            stream_id: 0: any that shows heat
        """
    async def camera_track_point(
            self, target_system: int | None = None, target_component: int | None = None, x: float = 0.5, y: float = 0.5,
            radius: float = 0.0,
    ) -> Ack:
        """Track what is at a point

        Args:
            x, y: Parts of the picture, 0…1
            radius: The same; 1 is the picture's width, 0: the camera chooses
        """
    async def camera_track_rectangle(
            self, target_system: int | None = None, target_component: int | None = None, left: float = 0.4,
            top: float = 0.4, right: float = 0.6, bottom: float = 0.6,
    ) -> Ack:
        """Track what is in a rectangle

        Args:
            left, top, right, bottom: Parts of the picture, 0…1
        """
    async def camera_stop_tracking(self, target_system: int | None = None, target_component: int | None = None) -> Ack:
        "Track no more"
    async def tracking(
            self, target_system: int | None = None, target_component: int | None = None,
    ) -> TrackingStatus | None:
        "What the camera tracks, and where that is; `None` when it does not tell"
    def tracking_updates(
            self, target_system: int | None = None, target_component: int | None = None, rate: float = 5.0,
    ) -> AsyncGenerator[Any, None]:
        """For `async for`: what the camera tracks, again and again. Raises `CommandError`, `NoAnswer`, `Lost`

        Args:
            rate: How many a second
        """
    async def do_set_cam_trigg_dist(
            self, target_system: int | None = None, target_component: int | None = None, distance: float = 0.0,
            shutter: float = 0.0, trigger: bool = False,
    ) -> Ack:
        """Have a picture taken whenever the vehicle has come so far

        Args:
            distance: Between two pictures, m; 0: no more
            shutter: How long it is open, ms; 0: as it is
            trigger: Take the first picture at once?
        """
    async def do_set_cam_trigg_interval(
            self, target_system: int | None = None, target_component: int | None = None, cycle: float = -1.0,
            shutter: float = 0.0,
    ) -> Ack:
        """Have a picture taken again and again

        Args:
            cycle: ms; 0 and -1: as it is
            shutter: How long it is open, ms; 0: as it is
        """
    async def do_trigger_control(
            self, target_system: int | None = None, target_component: int | None = None, enable: int = -1, reset: int = -1,
            pause: int = -1,
    ) -> Ack:
        """Begin again what was set before, or stop it

        Args:
            enable: 1: begin again what was set, 0: stop, -1: as it is
            reset: 1: count from 0
            pause: 1: pause
        """
    def next_ftp(self, numbers: int = 2) -> int:
        "A number for a request; a burst needs many"
    def next_ftp_session(self) -> int:
        "A number that we want for a session; a server may give us another one"
    def ftp_trip(self, target: tuple) -> RoundTrip:
        "How long a file server takes to answer, behind all that the link has to carry"
    def send_ftp(self, target: tuple, request: FtpFrame) -> None:
        "Send a request; raises `LinkError`"
    def ftp_place(self, target_system: Any, target_component: Any, path: str) -> tuple:
        "`((system, component), path)` of a file; a URL may name the component. Raises `MAVError` without a target"
    async def ask_ftp(self, target: tuple, op: int, *paths: Any, patience: float | None = None, **fields: Any) -> FtpFrame:
        """The answer to a request; raises `FtpError` when it is refused, `Lost` when none comes

        Args:
            target: `(system, component)`
            op: An `FtpOp`
            paths: Those that it is about
            patience: Seconds; `None`: `ftp_patience`
            fields: Others of the request
        """
    async def open_ftp(self, target: tuple, op: int, path: str, number: int) -> FtpFrame:
        "The answer of an operation that opens a file; when no session is free, we wait for one"
    async def same_sum(self, target: tuple, path: str, crc: int) -> bool | None:
        "Has the file this checksum? `None`: the server cannot tell"
    @overload
    async def download(
            self, target_system: int | None = None, target_component: int | None = None, path: str = '', to: None = None,
            progress: Any = None, most: int = ...,
    ) -> bytes:
        """Fetch a file: its bytes, or its path on our disk. Raises `FtpError`, `Lost` and `OSError`

        Args:
            path: On the vehicle, or a URL such as the `file_url` of a picture
            to: A file or a folder on our disk; `None`: give the bytes
            progress: A function of the bytes that are done and of all; true: show a line
            most: Bytes that we take into memory; a larger file is a `ValueError`
        """
    @overload
    async def download(
            self, target_system: int | None = None, target_component: int | None = None, path: str = '', *, to: str | Path,
            progress: Any = None, most: int = ...,
    ) -> Path: ...
    @overload
    async def download(
            self, target_system: int | None, target_component: int | None, path: str, to: str | Path, progress: Any = None,
            most: int = ...,
    ) -> Path: ...
    def on_param_ext_value(self, msg: Any) -> None:
        "Note what was set, or is told, of a camera that we have asked for its settings"
    async def get_parameter(
            self, target_system: int | None = None, target_component: int | None = None, name: str = '',
    ) -> Any:
        """The value of a setting, asked for now; raises `UnknownParameter`, `NoAnswer`

        Args:
            name: Of the parameter
        """
    async def camera_definition(self, target_system: int | None = None, target_component: int | None = None) -> list:
        "The declared `Parameter`s of a camera; empty when it has no definition. Raises `ValueError`, `NoAnswer`"
    async def parameters(
            self, target_system: int | None = None, target_component: int | None = None, definition: bool = True,
    ) -> RemoteParameters:
        """All settings of a camera: a table that follows what it tells, and what others set. Raises `NoAnswer`

        Args:
            definition: Fetch the definition too, which says what the values mean
        """
    async def set_parameter(
            self, target_system: int | None = None, target_component: int | None = None, name: str = '', value: Any = None,
    ) -> ParameterAck:
        """Set one; true when it was accepted. Raises `ValueError` when the value does not fit the type, `NoAnswer`

        Args:
            name: Of the parameter
            value: A number, the name of an option, or bytes
        """
    async def list_files(
            self, target_system: int | None = None, target_component: int | None = None, path: str = '/',
    ) -> list[FileEntry]:
        """A `FileEntry` for each file and folder; raises `FtpError` and `Lost`

        Args:
            path: Of a folder, or its URL
        """
    async def upload(
            self, target_system: int | None = None, target_component: int | None = None, path: str = '',
            content: bytes | str | Path = b'', progress: Any = None,
    ) -> None:
        """Write a file, in the place of one that is there; raises `FtpError`, `Lost` and `OSError`

        Args:
            path: On the vehicle, in a folder where we may write
            content: Bytes, or the path of a file on our disk
            progress: As for `download`
        """
    async def remove_file(
            self, target_system: int | None = None, target_component: int | None = None, path: str = '',
    ) -> None:
        """Remove a file; raises `FtpError`, when we may not, too

        Args:
            path: On the vehicle, or its URL
        """

@dataclass(frozen=True)
class RemoteCamera:
    "A camera that was found: where it is, and its CAMERA_INFORMATION"
    system: int
    component: int
    information: Any = ...
    @property
    def name(self) -> str:
        "Vendor and model"
    @property
    def can(self) -> list:
        "Names of its CAMERA_CAP_FLAGS"
def is_camera(source: tuple, mav_type: int) -> bool:
    "Is a component with this address and MAV_TYPE a camera?"

__all__ = [
    'NAN', 'CameraClient', 'RemoteCamera', 'is_camera', 'CAMERA_INFORMATION', 'CAMERA_SETTINGS', 'STORAGE_INFORMATION',
    'CAMERA_CAPTURE_STATUS', 'CAMERA_IMAGE_CAPTURED', 'LogLevels', 'mavlink',
]
