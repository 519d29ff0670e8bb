"A simulated aircraft for gimbals to hang from: it flies a path, and says at any time where it is and how it is held."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import VehicleState
from typing import Any

def circle(radius: float = 40.0, speed: float = 5.0, altitude: float = 30.0, middle: tuple = ...) -> Any:
    """A path round `middle`; it begins in the north of it

    Args:
        radius: m
        speed: m/s; a negative one flies anticlockwise
        altitude: Above the ground, m
        middle: North and east of the origin, m
    """
def line(
        speed: float = 5.0, heading: float = 0.0, climb: float = 0.0, altitude: float = 30.0, start: tuple = ...,
) -> Any:
    """A path straight on

    Args:
        speed: m/s over the ground
        heading: Degrees from north
        climb: m/s
        altitude: Above the ground at the beginning, m
        start: North and east of the origin, m
    """
def hover(altitude: float = 30.0, place: tuple = ...) -> Any:
    """A path that stays in one place

    Args:
        altitude: Above the ground, m
        place: North and east of the origin, m
    """
def strips(
        count: int = 4, length: float = 100.0, apart: float = 20.0, speed: float = 8.0, altitude: float = 40.0,
        start: tuple = ...,
) -> Any:
    """A path over a field, with half circles from strip to strip; it stays where the last one ends

    Args:
        count: Strips
        length: Of each, from south to north, m
        apart: From one strip to the next in the east, m
        speed: m/s over the ground
        altitude: Above the ground, m
        start: North and east of the origin: the south end of the first strip, m
    """

class SimVehicle:
    "Flies a path, exactly, and tells how"
    origin: tuple
    clock: Any
    heading: Any
    path: Any
    began: Any
    def __init__(self, path: Any = None, origin: tuple = ..., clock: Any = ..., heading: Any = None) -> None:
        """
        Args:
            path: Function: s since the start to (north, east, height above the ground) in m; `None`: `circle()`
            origin: Latitude, longitude, height above sea of the origin
            clock: Gives seconds
            heading: Degrees from north, or a function of the seconds; `None`: along the path
        """
    def position(self, t: float | None = None) -> tuple:
        """North, east (m from the origin) and height above the ground (m)

        Args:
            t: s on its clock; `None`: now
        """
    def velocity(self, t: float | None = None) -> tuple:
        """North, east and down, m/s

        Args:
            t: s on its clock; `None`: now
        """
    def yaw(self, t: float | None = None) -> float:
        """Where the nose points, degrees from north; a vehicle that hovers points north

        Args:
            t: s on its clock; `None`: now
        """
    def on_earth(self, north: float, east: float, up: float) -> tuple:
        """Latitude and longitude (degrees), and height above sea (m) of a place

        Args:
            north, east, up: m from the origin, and above the ground
        """
    def state(self, t: float | None = None) -> VehicleState:
        """How it is held, and where it is

        Args:
            t: s on its clock; `None`: now
        """
moment: float

__all__ = ['moment', 'circle', 'line', 'hover', 'strips', 'SimVehicle']
