"`Motor` simulates one axis of a gimbal, with limits to its angle, speed and acceleration."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import Axis
from typing import Any


class Motor:
    "One axis of a gimbal"
    near: float
    low: float
    high: float
    speed: float
    acceleration: float
    wraps: bool
    angle: Any
    rate: Any
    pressing: Any
    stuck: bool
    def __init__(
            self, low: float = ..., high: float = ..., speed: float = 60.0, acceleration: float = 200.0,
            wraps: bool = False,
    ) -> None:
        """
        Args:
            low, high: Where it can go, degrees
            speed: The fastest it turns, degrees a second
            acceleration: How fast it gets there, degrees a second, each second
            wraps: Are 190 and -170 the same to it, as for yaw?
        """
    def reachable(self, angle: float) -> float:
        """The angle it will go to for this one

        Args:
            angle: Degrees
        """
    def braking_speed(self, room: float, dt: float) -> float:
        """Degrees a second from which it can still stop there

        Args:
            room: Degrees until it must stand
            dt: s, one step
        """
    def carry(self, turn: float) -> None:
        """Be turned, as far as the limits let it

        Args:
            turn: Degrees
        """
    def step(self, target: Axis, dt: float) -> None:
        """Turn for `dt`

        Args:
            target: An angle, an angle at a rate, a rate, or neither
            dt: s, one step
        """

__all__ = ['Motor']
