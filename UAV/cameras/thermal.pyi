"What a thermal camera sees of the simulated world: a temperature for each pixel, and a palette that shows it."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.sim_world import SimWorld
from UAV.utils.values import Value
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

coldest: float
per_level: float
def level_of(celsius: float) -> int:
    "The level that stands for a temperature"
def celsius_of(levels: Any) -> Any:
    "The temperatures (float32, °C) that levels stand for"

class ThermalWorld(SimWorld):
    "A `SimWorld` whose pixels are temperatures, the same in all three channels"
    sky: Sequence
    haze: Sequence
    black: float
    white: float
    sides: Sequence
    @cached_property
    def tile(self) -> Any:
        "Grass is cool, dry ground is warm, and the roads are warmer"
thermal_world: Any
def paint(celsius: Any) -> Any:
    """The temperatures as a picture (BGR): black and violet are cold, yellow and white are hot

    Args:
        celsius: Temperatures, height x width
    """

@dataclass(frozen=True, repr=False, eq=False)
class ThermalRange(Value):
    "The hottest and the coldest place in a thermal picture"
    stream_id: int = ...
    max: float = ...
    max_point: tuple = ...
    min: float = ...
    min_point: tuple = ...
def range_of(celsius: Any, stream_id: int = 0) -> ThermalRange:
    """The range of a picture; a place is the middle of its pixel

    Args:
        celsius: Temperatures, height x width
        stream_id: Of which stream
    """

__all__ = [
    'coldest', 'per_level', 'level_of', 'celsius_of', 'ThermalWorld', 'thermal_world', 'paint', 'ThermalRange',
    'range_of',
]
