"A zoom lens and a focus drive, moved in all the ways that MAVLink has; and where a point of the world appears in the picture."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Sequence
from typing import Any


class Travel:
    "A position between two ends, that can also move by itself"
    low: float
    high: float
    duration: float
    clock: Any
    def __init__(self, low: float, high: float, duration: float = 4.0, clock: Any = ...) -> None:
        """
        Args:
            low: One end
            high: The other
            duration: Seconds from end to end at full speed
            clock: Gives seconds
        """
    def go(self, to: float) -> None:
        "Be at `to`, or at the end nearest to it, and stay there"
    @property
    def percent(self) -> Any:
        "Where it is, % of the way from `low` to `high`; NaN when there is no way"
    @percent.setter
    def percent(self, value: Any) -> None: ...
    @property
    def position(self) -> float:
        "Where it is now"
    def move(self, rate: float) -> None:
        """Move on by itself, until it comes to the end

        Args:
            rate: -1..1 of full speed; 0 stops
        """

class Lens:
    "A zoom lens"
    kinds: Sequence
    sensor_size_h: float
    step: float
    travel: Travel
    def __init__(
            self, focal_length: float = 2.8, max_focal_length: float = 28.0, sensor_size_h: float = 3.2, step: float = 1.1,
            duration: float = 4.0, clock: Any = ...,
    ) -> None:
        """
        Args:
            focal_length: Widest, mm
            max_focal_length: Longest, mm
            sensor_size_h: Width of the sensor, mm
            step: Factor of one zoom step
            duration: Seconds from end to end at full speed
            clock: Gives seconds
        """
    @property
    def focal_length(self) -> float:
        "mm, now"
    @property
    def percent(self) -> float:
        "0..100 % of the range, now"
    def reset(self) -> None:
        "Back to the low end: no zoom"
    def fov(self, focal_length: float) -> float:
        "Horizontal field of view at `focal_length` (mm), degrees"
    @property
    def horizontal_fov(self) -> float:
        "Horizontal field of view now, degrees"
    def zoom(self, kind: str, value: float) -> None:
        """Zoom one of five ways (CAMERA_ZOOM_TYPE); raises `ValueError`

        Args:
            kind: One of `kinds`
            value: Steps (tele is positive), speed -1..1, % of the range, mm or degrees
        """

class Focus:
    "A focus drive"
    kinds: Sequence
    near: float
    distance: float
    travel: Travel
    def __init__(self, near: float = 0.5, distance: float = ..., duration: float = 2.0, clock: Any = ...) -> None:
        """
        Args:
            near: Nearest distance, m
            distance: What autofocus finds, m
            duration: Seconds from end to end at full speed
            clock: Gives seconds
        """
    @property
    def percent(self) -> Any:
        "0 is nearest, 100 is infinity"
    def reset(self) -> None:
        "Focus on what autofocus finds"
    def at(self, distance: Any) -> Any:
        "The position for `distance` (m), %: 0 is nearest, 100 is infinity"
    def focus(self, kind: str, value: float = 0.0) -> Any:
        """Focus one of seven ways (SET_FOCUS_TYPE); raises `ValueError`

        Args:
            kind: One of `kinds`
            value: Steps of 5 %, speed -1..1, % of the range or m; 'auto…' needs none
        """
def rotation(roll: float, pitch: float, yaw: float) -> Any:
    "3x3 matrix that turns body axes (forward, right, down) into north, east, down; angles in degrees"
def angles(matrix: Any) -> tuple:
    "(roll, pitch, yaw) in degrees of a matrix made by `rotation`"

class View:
    "A pinhole camera at a place: says where a point of the world appears in the picture"
    size: tuple
    position: Any
    above: Any
    f: Any
    K: Any
    R: Any
    def __init__(self, size: tuple, horizontal_fov: float, position: tuple, attitude: tuple) -> None:
        """
        Args:
            size: Width and height of the picture, px
            horizontal_fov: Degrees
            position: North, east, down, m
            attitude: Roll, pitch, yaw, degrees
        """
    def project(self, points: Any) -> Any:
        """Pixels (n x 2) and depths (n)

        Args:
            points: North, east, down, m: n x 3
        """
    def rows(self, first: int, last: int) -> Any:
        "The view of some rows of the picture only"
    def plane(self, origin: Any, across: Any, down: Any) -> Any:
        "3x3 homography: from `(a, b, 1)`, which is the place `origin + a*across + b*down`, to pixels"
    def on_ground(self, x: float, y: float) -> tuple | None:
        """North and east of the place on the ground that is seen at a pixel, m; `None`: the sky, or too flat to say

        Args:
            x, y: px
        """

__all__ = ['Travel', 'Lens', 'Focus', 'rotation', 'angles', 'View']
