"`Frames` gives the newest frame of a camera to all its readers, and reads the camera only while there are some."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import Frame
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any


class Frames:
    "The newest frame of a camera, for all who look"
    camera: Any
    newest: Any
    watchers: int
    closed: bool
    def __init__(self, camera: Any) -> None:
        """
        Args:
            camera: Its `read`, `set_fault`, `frame_rate` and `patience` are used; and `next_frame(after)`, if it has that
        """
    @contextmanager
    def watching(self) -> Generator[Any, None, None]:
        "For a `with`: have the camera read; raises `CameraError` when it is closed, or the system has no thread left"
    def next(self, after: int = -1, timeout: float | None = None) -> Frame | None:
        """The newest frame, but later than `after`: waits for it. `None` on timeout, and after `close`

        Args:
            after: The number of the last frame seen
            timeout: s; `None` waits as long as it takes
        """
    def still(self) -> Frame:
        "A frame that comes after the call; raises `CameraError` when none comes for `patience`, and what `read` raises"
    def close(self, timeout: float = 1.0) -> bool:
        """Read no more; false when the device does not come back. May be called twice

        Args:
            timeout: s that a read under way may take
        """

__all__ = ['Frames']
