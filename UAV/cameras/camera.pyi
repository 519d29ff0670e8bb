"The base class of all cameras. You write `information` and `read`, and get pictures, series, streams and storage."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
from UAV.cameras.capture import CaptureQueue, DeviceWatch
from UAV.cameras.filming import Filming
from UAV.cameras.frames import Frames
from UAV.cameras.parameters import Parameters
from UAV.cameras.storage import Storage
from UAV.cameras.storages import Storages
from UAV.cameras.tracker import Tracker
from UAV.cameras.values import CameraInformation, CameraSettings, CaptureStatus, Frame, Picture, Pose
from UAV.utils.complete import CompleteLater
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from typing_extensions import Self

def check_unused(storage: Storage) -> None:
    "Raise `StorageInUse` when an open camera has this storage: it counts for one"

class Camera(metaclass=CompleteLater):
    "A camera; subclasses give `information` and `read()`, and the optional verbs they can do"
    information: CameraInformation
    min_interval: float
    jpeg_quality: int
    modes: Sequence
    image_in_video_mode: bool
    video_in_image_mode: bool
    max_waiting: int
    patience: float
    frame_rate: float
    exif_tags: Any
    lens: Any
    focus: Any
    mode: str
    gimbal_device_id: int
    pose: Any
    clock_error: float
    declared: Sequence
    trigger_setting: tuple | Any
    mounted: Any
    velocity: Any
    storages: Storages
    log: logging.Logger
    captures: CaptureQueue
    device_watch: DeviceWatch
    frames: Frames
    filming: Filming
    tracking: Tracker
    def __init__(
            self, folder: str | Path | None = None, quota: float | None = None, storage: Storage | None = None,
            storages: list | None = None,
    ) -> None:
        """Raises `StorageInUse` when another camera has the folder or the storage

        Args:
            folder: Where pictures go; `None` is a temporary folder that `close` removes
            quota: MiB the pictures may fill; `None` is the whole disk
            storage: In place of `folder` and `quota`; `close` closes it
            storages: Several, in place of all three
        """
    def read(self) -> Frame:
        "The newest frame; a subclass has it"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "Stop, wait for the picture being taken (`patience` at most), and let go of the storage; may be called twice"
    @property
    def storage(self) -> Any:
        "The first storage"
    @property
    def fault(self) -> Any:
        "What is wrong with the device; `None`: it works"
    @property
    def recording(self) -> Any:
        "Is a video being recorded?"
    @property
    def recording_time(self) -> Any:
        "Length of that video, s"
    def subscribe(self, callback: Any) -> None:
        """Tell `callback` of all that happens: a Picture, CaptureStatus, CameraSettings, ParametersChanged, DeviceStatus …

        Args:
            callback: Called with each event; must be quick
        """
    def unsubscribe(self, callback: Any) -> None:
        "Stop telling `callback`"
    def announce(self, event: Any) -> None:
        "Tell every listener"
    def settings(self) -> CameraSettings:
        "How the camera is set"
    def capture_status(self) -> CaptureStatus:
        "What the camera is doing"
    def storage_information(self) -> list:
        "How full the storages are"
    def storage_for(self, medium: str) -> Storage:
        """Where it goes now; raises `ValueError`

        Args:
            medium: 'photo' or 'video'
        """
    def set_fault(self, fault: str | None, error: BaseException | None = None) -> None:
        """Note whether the device works; listeners get a `DeviceStatus` when that is news

        Args:
            fault: What is wrong with the device; `None`: it works
            error: What was raised, when it is a surprise
        """
    def image_start_capture(self, interval: float = 0.0, count: int = 1) -> int:
        """Take pictures, and return at once; raises `ValueError`, `CameraBusy`, `WrongMode` or `StorageError`

        Args:
            interval: Seconds between pictures; raised to `min_interval`
            count: How many pictures; 0 until stopped
        """
    def image_stop_capture(self) -> None:
        "End a sequence, and return at once; what was accepted is taken: the picture under way, and singles that wait"
    def wait_idle(self, timeout: float | None = None) -> bool:
        """Wait until nothing is being taken and all is announced; False on timeout. Not for callbacks

        Args:
            timeout: s; `None` waits as long as it takes
        """
    def read_still(self) -> Frame:
        "The frame a picture is made of; override it when the camera has something better than a frame for stills"
    @property
    def pictures(self) -> tuple:
        "All shots of the count, by index"
    def picture(self, index: int) -> Picture:
        """One shot; raises `IndexError` when there is none

        Args:
            index: From 0
        """
    def storage_format(self, storage_id: int = 1, cancelled: Any = ...) -> None:
        """Delete what is on a storage; raises `ValueError` when it is not there, `CameraBusy` while in use, `TakenBack`

        Args:
            storage_id: As in StorageInformation
            cancelled: Says whether it is to end without having deleted anything
        """
    def after_fork(self) -> None:
        "In a forked process: this camera is the parent's. Its locks are made anew: a thread may have held them"
    def apply_parameter(self, name: str, value: Any) -> dict | None:
        """Put a value into the device, within `patience`; a subclass has it. May raise `ValueError` or `CameraError`

        Args:
            name: Of the parameter
            value: In its type, in its range
        """
    @property
    def parameters(self) -> Parameters:
        "What can be set, and how it is set now"
    def reset_camera_settings(self) -> None:
        "Mode, zoom, focus and parameters as they were at first; raises, at the end, what the device raised"
    def set_storage_usage(self, storage_id: int, usage: Any) -> None:
        """Say what goes to a storage; listeners get each one that changed. Raises `ValueError`, `StorageError`, `CameraBusy`

        Args:
            storage_id: As in StorageInformation
            usage: What it is for from now on: a set of 'photo' and 'video'
        """
    def reset_image_log(self, storage_id: int = 1) -> None:
        """Take the pictures of a storage out of the count, which begins anew when it is the photo storage; files stay

        Args:
            storage_id: As in StorageInformation
        """
    @property
    def trigger(self) -> Any:
        "Takes pictures by distance"
    def set_trigger_distance(self, distance: float, now: bool = False) -> Any:
        """Take a picture every `distance` m; raises `ValueError`, `CameraBusy` (`PlaceUnknown`), `WrongMode`, `StorageError`

        Args:
            distance: Between two pictures, m; 0: take no more
            now: Take the first one at once, and not after the first distance?
        """
    def set_trigger_interval(self, interval: float) -> None:
        """Take a picture every `interval` s, in place of what runs; raises as `image_start_capture`. Not for callbacks

        Args:
            interval: s
        """
    def trigger_control(self, enable: bool | None = None, reset: bool = False) -> Any:
        """Stop what was set, or begin it again; raises `CameraError` when nothing was

        Args:
            enable: Take pictures as was set last? `None`: leave it
            reset: Count them from 0 again
        """
    def camera_track_rectangle(self, left: float, top: float, right: float, bottom: float) -> None:
        """Track what is in the rectangle from the next frame on; raises `ValueError`, and `CameraError` when closed

        Args:
            left, top, right, bottom: Parts of the picture, 0…1
        """
    def camera_track_point(self, x: float, y: float, radius: float = 0.0) -> None:
        """Track what is at a point from the next frame on; raises `ValueError`, and `CameraError` when closed

        Args:
            x, y: Parts of the picture, 0…1
            radius: The same; 1 is the picture's width, 0: the camera chooses
        """
    def camera_stop_tracking(self) -> None:
        "Track no more; fine when nothing is tracked"
    def target_place(self, frame: Frame, point: tuple) -> Pose | None:
        """The place on the ground that is seen at a point; `None`: it is not known

        Args:
            frame: What was seen
            point: Where in the picture: x, y, 0…1
        """
    @property
    def streams(self) -> tuple:
        "The streams of this camera; the first has number 1"
    def add_stream(
            self, name: str = '', kind: str = 'rtsp', host: str = '', port: int | None = None, codec: str = 'h264',
            size: tuple | None = None, rate: float = 15.0, bitrate: int | None = None, uri: str = '', **how: Any
    ) -> Any:
        """A new stream, which runs at once; raises `ValueError` for a name that is taken, `OSError` for a port that is

        Args:
            name: For people; empty: the model and a number
            kind: 'rtsp', 'rtp', 'mpegts' or 'tcp'
            host: Where 'rtp' and 'mpegts' send to (this machine); the address that a server listens at (all)
            port: `None` is the usual one of its kind; 0: a server takes a free one
            codec: 'h264' or 'h265'
            size: (width, height) in px; `None`: that of the frames
            rate: Pictures in a second, at most
            bitrate: bit/s; `None`: what suits size and rate
            uri: What viewers are told, in place of what we think
            how: `source`, for a camera with several
        """
    def make_encoder(self, codec: str, size: tuple | None, rate: float, bitrate: int | None) -> Any:
        """An encoder of our frames; a camera that encodes by itself overrides this, and hands out its own pictures

        Args:
            codec: 'h264' or 'h265'
            size: (width, height) in px; `None`: that of the frames
            rate: Pictures in a second, at most
            bitrate: bit/s; `None`: what suits size and rate
        """
    def video_start_streaming(self, stream_id: int = 0, host: str | None = None) -> None:
        """Start a stream; raises `ValueError` for one that is not there

        Args:
            stream_id: 0: all
            host: Where 'rtp' and 'mpegts' send to; `None`: as before
        """
    def video_stop_streaming(self, stream_id: int = 0) -> None:
        """Stop a stream; raises `ValueError` for one that is not there

        Args:
            stream_id: 0: all
        """
    def video_start_capture(self, stream_id: int = 0) -> None:
        """Begin to record; raises `CameraBusy`, `WrongMode`, `StorageError`, or `ValueError` for a stream that is not there

        Args:
            stream_id: Whose pictures; 0: those of the first stream, or the camera's own
        """
    def video_stop_capture(self, stream_id: int = 0) -> None:
        """End the recording; its file is complete then, unless the disk hangs. Raises `ValueError` for no stream of ours

        Args:
            stream_id: There is one recording: any stream of ours will do
        """
def close_cameras() -> None:
    "Close every camera that is still open; waits for a device that hangs for its `patience` at most"

__all__ = ['check_unused', 'Camera', 'close_cameras']
