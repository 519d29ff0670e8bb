"Take pictures with a USB camera, or from a video file or a network stream, through OpenCV."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.camera import Camera
from UAV.cameras.controls import Controls
from UAV.cameras.values import CameraInformation, Frame
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

def source_kind(source: Any) -> str:
    """'device', 'url' or 'file'

    Args:
        source: Device number or path, file name, or URL
    """
def source_name(source: Any) -> str:
    "The source for people: quoted, and without user and password"
@contextmanager
def silent_cv2() -> Generator[Any, None, None]:
    "OpenCV prints what it tries; we raise what went wrong"
def how_to_open(source: Any, open_timeout: float, read_timeout: float, backend: int | None) -> tuple:
    "The arguments of `cv2.VideoCapture`: name, backend and parameters; raises `CameraError` when there is no such file"
def open_source(source: Any, open_timeout: float = 5.0, read_timeout: float = 5.0, backend: int | None = None) -> Any:
    """Open a source and read its first image; raises `CameraError` that names the source

    Args:
        source: Device number or path, file name, or URL
        open_timeout: Seconds until a URL must be open
        read_timeout: Seconds a URL may be silent
        backend: `cv2.CAP_…`; `None` leaves the choice to OpenCV
    """

class CV2Camera(Camera):
    "A camera that OpenCV can open"
    first_retry: float
    last_retry: float
    source: Any
    width: Any
    height: Any
    fps: float | None
    loop: bool
    open_timeout: float
    read_timeout: float
    backend: int | None
    pose: Any
    kind: str
    paced: Any
    lockstep: Any
    controls: Controls
    def __init__(
            self, source: Any, width: int | None = None, height: int | None = None, fps: float | None = None,
            loop: bool = True, paced: bool = True, open_timeout: float = 5.0, read_timeout: float = 5.0,
            backend: int | None = None, model: str = 'CV2Camera', folder: str | Path | None = None,
            quota: float | None = None, storages: list | None = None, pose: Any = None,
    ) -> None:
        """
        Args:
            source: Device number or path, file name, or URL (rtsp, http, udp, tcp)
            width, height: px; frames are scaled when the source has another size
            fps: Frames per second; `None` is what the source says
            loop: Start a file again at its end
            paced: Play a file in its own time; False waits for each frame to be read
            open_timeout, read_timeout: Seconds
            backend: `cv2.CAP_…`; `None` leaves the choice to OpenCV
            model: As in CameraInformation
            folder, quota, storages: As for Camera
            pose: Function that gives the Pose of a picture, from an autopilot or a gimbal, say
        """
    def close(self) -> None:
        "Stop, and wait for the reader to let go of the source; may be called twice"
    def after_fork(self) -> None:
        "In a forked process: the source is the parent's"
    def next_frame(self, after: int = -1) -> Frame:
        """The newest frame, but later than `after`: waits for it; raises `CameraError` when none comes for `read_timeout`

        Args:
            after: The number of the last frame seen
        """
    def read(self) -> Frame:
        "The newest frame; raises `CameraError` when the source has given none for `read_timeout`, has ended, or is closed"
    def read_still(self) -> Frame:
        "The newest frame, watched or not"
    def apply_parameter(self, name: str, value: Any) -> dict | None:
        "Set it in the device; raises `CameraError` when it refuses, or gives no frames"

__all__ = ['source_kind', 'source_name', 'silent_cv2', 'how_to_open', 'open_source', 'CV2Camera']
