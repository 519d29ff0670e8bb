"Estimate where an axis points from what it was told, for a gimbal that reports nothing."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Reckoned:
    "Where one axis is believed to be, by what it was told"
    lasts: float
    speed: float
    low: float
    high: float
    angle: Any
    rate: float
    goal: float | Any
    sure: bool
    told: bool
    def __init__(self, speed: float, low: float = ..., high: float = ...) -> None:
        """
        Args:
            speed: Degrees a second, on the way to an angle
            low, high: Degrees
        """
    def near(self, angle: float) -> float:
        "The same angle, as the axis names it"
    def at(self, now: float) -> float:
        """Its angle, degrees

        Args:
            now: s
        """
    def go(self, goal: float, now: float) -> None:
        """It was told to go to this angle

        Args:
            goal: Degrees
            now: s
        """
    def turn(self, rate: float, now: float) -> None:
        """It was told to turn with this rate

        Args:
            rate: Degrees a second
            now: s
        """
    def aim(self, now: float) -> float:
        """Where it will stop, degrees; NaN: it may be anywhere

        Args:
            now: s
        """
    def be(self, angle: float, now: float) -> None:
        """It reports its angle

        Args:
            angle: Degrees
            now: s
        """

__all__ = ['Reckoned']
