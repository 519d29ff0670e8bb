"`DistanceTrigger` takes positions, and says when the next picture is due."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class DistanceTrigger:
    "Says when the vehicle has come so far that the next picture is due"
    least: float
    most: float
    slack: float
    fastest: float
    standing: float
    drift: float
    pause: float
    distance: float
    anchor: Any
    stood: Any
    last: tuple | Any
    tells_speed: Any
    late: Any
    def __init__(self, distance: float) -> None:
        """Raises `ValueError`

        Args:
            distance: Between two pictures, m
        """
    @property
    def flown(self) -> float:
        "m from the last picture to the last position, as a great circle"
    @property
    def due(self) -> bool:
        "Is the next picture due? The way flown has reached `distance`, less what the last one came too late (m)"
    def taken(self) -> None:
        "The picture was taken, at the last position"
    def feed(self, moment: float, lat: float, lon: float, north: float = ..., east: float = ...) -> bool:
        """Take a position; is a picture due?

        Args:
            moment: s
            lat, lon: Degrees
            north, east: Velocity, m/s
        """

__all__ = ['DistanceTrigger']
