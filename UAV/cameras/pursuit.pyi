"`Pursuit` takes a rectangle or a point to track, and says for each frame where the target is now."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import Frame, Pose
from UAV.utils.values import Value
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False, eq=False)
class TrackingStatus(Value):
    "What a camera tracks; all lengths are parts of the picture"
    status: str = ...
    mode: str = ...
    rectangle: tuple | None = ...
    point: tuple | None = ...
    radius: float = ...
    frame: Frame | None = ...
    confidence: float = ...
    place: Pose | None = ...
    why: str = ...
def checked_rectangle(left: float, top: float, right: float, bottom: float) -> tuple:
    "The four, as floats; raises `ValueError` unless they are 0…1, and the rectangle is not empty"

class Pursuit:
    "One target, from the command on"
    default_radius: float
    mode: str
    asked: tuple
    follower: Any
    size: Any
    focal_length: Any
    number: Any
    seen: Any
    heard: Any
    def __init__(self, rectangle: tuple | None = None, point: tuple | None = None, radius: float = 0.0) -> None:
        """Raises `ValueError`

        Args:
            rectangle: Left, top, right, bottom
            point: Or x, y
            radius: Half a side of the square around the point; 0: we choose
        """
    def look(self, frame: Frame, focal_length: float = ...) -> TrackingStatus:
        """How it stands in this frame; raises `ValueError` for one that is no picture

        Args:
            frame: The next one of the camera
            focal_length: With which it was taken, mm
        """
def focal(told: Any, before: float = ...) -> float:
    """A focal length, mm; what it was before when a lens cannot have that

    Args:
        told: By a lens, mm
        before: What it was, mm
    """

__all__ = ['TrackingStatus', 'checked_rectangle', 'Pursuit', 'focal']
