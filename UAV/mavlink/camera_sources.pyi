"Choose which eye of a camera you see, and learn how hot it is: SET_CAMERA_SOURCE and CAMERA_THERMAL_RANGE from both ends."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.thermal import ThermalRange
from typing import Any

CAMERA_THERMAL_RANGE: int
def thermal_range_of(msg: Any) -> ThermalRange:
    """What a message tells

    Args:
        msg: A CAMERA_THERMAL_RANGE
    """

__all__ = ['thermal_range_of', 'CAMERA_THERMAL_RANGE']
