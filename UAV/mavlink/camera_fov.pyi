"CAMERA_FOV_STATUS from both ends: where the camera is and looks, how wide it sees, and which place is in the middle of its picture."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import Pose
from UAV.utils.values import Value
from dataclasses import dataclass
from typing import Any

CAMERA_FOV_STATUS: int
def field_of_view(camera: Any) -> tuple:
    """Horizontal and vertical field of view now, degrees; NaN when not known

    Args:
        camera: A Camera, or an object with `information`
    """
earth_radius: float
def image_center(pose: Pose) -> tuple:
    """Latitude, longitude and altitude (m above the sea) in the middle of a picture; `inf`: it shows the sky

    Args:
        pose: Of the camera
    """
def footprint(pose: Pose, fov: tuple) -> list:
    """`(lat, lon)` of the corners on the ground: left and right above, right and left below; `inf` in the sky

    Args:
        pose: Of the camera
        fov: As from `field_of_view`, degrees
    """
not_known: int
sky: int
def as_int32(value: float, scale: float) -> int:
    """A coordinate as CAMERA_FOV_STATUS has it

    Args:
        value: NaN: not known; `inf`: the sky
        scale: Units of the wire in one of ours
    """
def from_int32(number: int, scale: float) -> float:
    "The way back"

@dataclass(frozen=True, repr=False, eq=False)
class FieldOfView(Value):
    "What a camera sees, as CAMERA_FOV_STATUS tells it; what is unknown is NaN"
    pose: Pose
    hfov: float = ...
    vfov: float = ...
    center: tuple = ...
def fov_of(msg: Any) -> FieldOfView:
    """What a message tells

    Args:
        msg: A CAMERA_FOV_STATUS
    """

__all__ = [
    'earth_radius', 'not_known', 'sky', 'field_of_view', 'image_center', 'footprint', 'as_int32', 'from_int32',
    'FieldOfView', 'fov_of', 'CAMERA_FOV_STATUS',
]
