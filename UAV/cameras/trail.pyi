"Where a vehicle was and how it was held at the moment of a picture, between two reports and a little after the last."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import Pose
from typing import Any


class Reports:
    "What was told of the last seconds, by the moment that it is true for"
    lasts: float
    most: int
    def __init__(self) -> None: ...
    def __len__(self) -> Any: ...
    def add(self, t: float, value: Any) -> None:
        """Keep a report; a second one of the same moment takes its place

        Args:
            t: The moment, s
            value: What was true then
        """
    def near(self, t: float, least: float = 0.0) -> tuple:
        """The two reports around `t` as `(moment, value)`, or the last two before it; `None` where there is none

        Args:
            t: The moment, s
            least: s that the first of the two is before the second, at least
        """
def between(seconds: float, part: float, way: float, first: float, second: float) -> float:
    """m from the first place, on the curve that has both velocities; a straight line when they are not known

    Args:
        seconds: From the first report to the second
        part: 0 at the first, 1 at the second
        way: m from the first to the second
        first, second: Velocities, m/s
    """
def beyond(seconds: float, velocity: float, acceleration: float) -> float:
    """m from the last place, when it goes on like that; 0 when the velocity is not known

    Args:
        seconds: Since the last report
        velocity: m/s
        acceleration: m/s²
    """

class PositionTrail(Reports):
    "Where a vehicle was: `(Pose, (north, east, down) in m/s)` of each report"
    gap: float
    reach: float
    def at(self, t: float) -> Pose | None:
        """The place at `t`; `None` when it cannot be known

        Args:
            t: The moment, s
        """
def part_of_turn(start: tuple, end: tuple, part: float) -> tuple:
    """The attitude on the shortest way

    Args:
        start, end: Quaternions
        part: 0 is `start`, 1 is `end`, and more is beyond it
    """

class AttitudeTrail(Reports):
    "How something was held: a quaternion of each report"
    gap: float
    reach: float
    ahead: float
    apart: float
    def at(self, t: float) -> tuple | None:
        """The attitude at `t`; `None` when it cannot be known

        Args:
            t: The moment, s
        """

__all__ = ['Reports', 'between', 'beyond', 'PositionTrail', 'part_of_turn', 'AttitudeTrail']
