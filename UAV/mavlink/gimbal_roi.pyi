"Point a gimbal at a place on the ground or at another aircraft, and end it: three commands, and the altitude that each sender means."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.region import Location
from UAV.gimbals.values import VehicleState
from UAV.mavlink.gimbal_vehicle import VehicleHeard
from typing import Any

alt_frames: dict
def location_of(msg: Any, long_alt: str = 'amsl') -> Location:
    """The place in a command; raises `Denied` for a frame that we cannot count in, `ValueError` for no place

    Args:
        msg: COMMAND_LONG with degrees, or COMMAND_INT with 1e-7 degrees
        long_alt: What the altitude of a COMMAND_LONG is: or 'relative'
    """
def seen_now(heard: VehicleHeard) -> VehicleState:
    "Where a vehicle is now, as far as it was heard"

__all__ = ['alt_frames', 'location_of', 'seen_now']
