"Work out the pitch and yaw at which a gimbal sees a place on earth."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.gimbal import Gimbal
from UAV.gimbals.values import VehicleState
from UAV.utils.values import Value
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False, eq=False)
class Location(Value):
    "A place on earth; raises `ValueError` for one that cannot be"
    lat: float
    lon: float
    alt: float = ...
    alt_frame: str = ...
def altitude_of(state: VehicleState, alt_frame: str) -> float:
    """The vehicle's altitude as `alt_frame` counts it, m; raises `PositionUnknown`

    Args:
        state: Where the vehicle is
        alt_frame: 'amsl' or 'relative'
    """
def offset(state: VehicleState, location: Location) -> tuple:
    """`(north, east, down)` from the vehicle to `location`, m; raises `PositionUnknown`

    Args:
        state: Where the vehicle is
        location: Where to look
    """
near: float
def direction(state: VehicleState, location: Location) -> tuple:
    """`(pitch, yaw)` in degrees, pitch from the horizon and yaw from north; NaN: hold it. Raises `PositionUnknown`

    Args:
        state: Where the vehicle is
        location: Where to look
    """
def ahead(state: VehicleState, seconds: float) -> VehicleState:
    """Where it is now, if it has flown straight on; the same `state` when position or velocity are not known

    Args:
        state: Where the vehicle was
        seconds: Since then
    """

class RegionOfInterest:
    "Keeps a gimbal looking at a place"
    lead: float
    gimbal: Gimbal
    target: Any
    before: Any
    ours: Any
    lost: str
    def __init__(self, gimbal: Gimbal) -> None: ...
    def look(self, state: VehicleState) -> None:
        "Look there, from where the vehicle is"
    def set(self, target: Any, state: VehicleState) -> None:
        """Look at `target` from now on; raises what `Gimbal.look_at` raises

        Args:
            target: A `Location`, or a function that gives it in so many seconds from now, or raises `PositionUnknown`
            state: Where the vehicle is
        """
    def tick(self, state: VehicleState) -> str:
        """Look there again; the news, when we cannot any more, or can again

        Args:
            state: Where the vehicle is
        """
    def cancel(self) -> None:
        "Forget it, because the gimbal is told something else; a `tick` that is under way ends before"
    @contextmanager
    def giving_way(self) -> Generator[Any, None, None]:
        "For a `with` that tells the gimbal something else: it is forgotten, unless that fails"
    def end(self) -> None:
        "Return to what the gimbal was told before"

__all__ = ['near', 'Location', 'altitude_of', 'offset', 'direction', 'ahead', 'RegionOfInterest']
