"Answer DO_MOUNT_CONTROL of older scripts and missions, and send the MOUNT_ORIENTATION that overlays read."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.region import Location
from UAV.mavlink.gimbal_flags import Target

mount_modes: dict
def mount_target(mode: int, roll: float = ..., pitch: float = ..., yaw: float = ...) -> Target:
    """What a mount command wants; raises `Unsupported` for other modes, `ValueError` for angles that cannot be

    Args:
        mode: MAV_MOUNT_MODE
        roll, pitch, yaw: Degrees, yaw from the nose; NaN keeps
    """
def mount_location(lat: float, lon: float, alt: float, alt_frame: str = 'amsl') -> Location:
    """The place in a mount command; raises `ValueError`

    Args:
        lat, lon: Degrees, or ten-millionths of a degree
        alt: m
        alt_frame: From where it is counted: 'amsl' or 'relative'
    """

__all__ = ['mount_modes', 'mount_target', 'mount_location']
