"Take pictures and stream with a camera that GStreamer opens, on a Jetson, a Raspberry Pi or the network."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.cameras.camera import Camera
from UAV.cameras.cv2_camera import CV2Camera as CV2Camera
from UAV.cameras.gst_controls import GSTControls
from UAV.cameras.gst_keeper import Keeper
from UAV.cameras.pipelines import Recipe, config_file as config_file
from UAV.cameras.values import Frame
from UAV.video.passthrough import PassThrough
from UAV.video.units import VideoFormat
from pathlib import Path
from typing import Any

BaseCamera = Camera

class Newest:
    "The newest frame, for all who wait for it"
    frame: Frame | Any
    number: int
    ended: str | Any
    open: bool
    asked: Any
    waiting: Any
    changed: threading.Condition
    def __init__(self) -> None: ...
    def put(self, image: Any, time_utc: float) -> None:
        "Take in the newest picture (BGR), which was taken at `time_utc` (s since 1970), and wake those who wait"
    def end(self, why: str) -> None:
        "No frame will come any more: why"
    def wait(self, after: int, timeout: float, problem: Any) -> Frame | None:
        "A frame later than `after`; `None` when none comes, also because there is a `problem()`"

class GSTCamera(Camera):
    "A camera that GStreamer can open"
    first_retry: float
    last_retry: float
    lease: float
    close_timeout: float
    open_timeout: float
    read_timeout: float
    pose: Any
    recipe: Recipe
    controls: GSTControls
    newest: Newest
    keeper: Keeper
    encoder: PipelineEncoder | Any
    def __init__(
            self, config: Any = None, camera_dict: dict | None = None, loglevel: int = ..., open_timeout: float = 10.0,
            read_timeout: float = 3.0, folder: str | Path | None = None, quota: float | None = None,
            storages: list | None = None, pose: Any = None,
    ) -> None:
        """Raises `ValueError` when the configuration makes no sense, and `CameraError` when there is no picture

        Args:
            config: A pipeline: a string, or a list of strings that `!` joins; or the name of a TOML file
            camera_dict: Sections as in a TOML file, which count more than the file's
            open_timeout, read_timeout: s until the first frame, and between two of them
            folder, quota, storages: As for Camera
            pose: Function that gives the Pose of a picture, from an autopilot or a gimbal, say
        """
    @property
    def line(self) -> Any:
        "The whole pipeline, as GStreamer gets it"
    @property
    def position(self) -> Any:
        "On the vehicle: x, y, z (m), roll, pitch, yaw (°)"
    def close(self) -> None:
        "Stop, and let go of the source; may be called twice"
    def after_fork(self) -> None:
        "In a forked process: the source is the parent's"
    def prepare(self, pipeline: Any) -> None:
        "Take what a new pipeline gives; called on the keeper's thread"
    def on_beat(self) -> None:
        "Close the valve when none has asked for a while; the keeper calls it"
    def next_frame(self, after: int = -1, timeout: float | None = None) -> Frame:
        """The newest frame, but later than `after`: waits for it; raises `CameraError` when none comes

        Args:
            after: The number of the last frame seen
            timeout: s; `None`: `read_timeout`, or `open_timeout` when a key picture must come first
        """
    def read(self) -> Frame:
        "The newest frame; raises `CameraError` when the source gives none, or is closed"
    def on_problem(self, problem: str | None) -> None:
        "The source has a problem, or has it no longer; called by the keeper"
    def read_still(self) -> Frame:
        "The newest frame, watched or not"
    def apply_parameter(self, name: str, value: Any) -> dict | None:
        "Set it in the pipeline; raises `CameraError` while the source does not run"
    def make_encoder(self, codec: str, size: tuple | None, rate: float, bitrate: int | None) -> Any:
        "The pipeline's own encoder, when it fits; else one for our frames"

class PipelineEncoder(PassThrough):
    "The access units of a camera's pipeline"
    camera: Any
    wish: Any
    made: Any
    expected: VideoFormat | Any
    def __init__(self, camera: Any, codec: str) -> None: ...
    def run(self, on: Any) -> None: ...
    def ask_key(self) -> None: ...
    def set_bitrate(self, bitrate: Any) -> None: ...
    def prepare(self, pipeline: Any) -> None:
        "Take what a new pipeline gives"
    def expect(self, frame: Frame) -> None:
        "Say what the units will be like, before the first one: as large as `frame`"

__all__ = ['BaseCamera', 'Newest', 'GSTCamera', 'PipelineEncoder', 'CV2Camera', 'config_file']
