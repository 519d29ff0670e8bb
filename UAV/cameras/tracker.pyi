"A thread that follows a target in the camera's frames, and tells where it is and when it is lost."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.pursuit import Pursuit, TrackingStatus
from typing import Any


class Tracker:
    "Tracks one target on the frames of a camera"
    patience: float
    silence: float
    camera: Any
    clock: Any
    status: TrackingStatus
    closed: bool
    def __init__(self, camera: Any, clock: Any = ...) -> None:
        """
        Args:
            camera: Its `frames`, `lens`, `fault`, `log` and `announce` are used; `target_place`, if it has that
            clock: Gives seconds
        """
    def see(self, pursuit: Pursuit, frame: Any) -> None:
        "The next frame for this target; `None`: none came"
    def start(self, pursuit: Pursuit) -> None:
        """Track this from the next frame on, in place of what was tracked before; raises `CameraError` when closed

        Args:
            pursuit: What to track
        """
    def stop(self) -> None:
        "Track no more; fine when nothing is tracked"
    def next(self, after: int = -1, timeout: float | None = None) -> TrackingStatus | None:
        """How it stands in a later frame than `after`: waits for it. `None` on timeout, and when nothing is tracked

        Args:
            after: The number of the last frame seen
            timeout: s; `None` waits as long as it takes
        """
    def close(self, timeout: float = 5.0) -> bool:
        """Track no more, for good; false when the thread does not end. May be called twice

        Args:
            timeout: s that a frame under way may take
        """

__all__ = ['Tracker']
