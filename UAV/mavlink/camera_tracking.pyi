"Track a point or a rectangle from the ground, and hear where the target is, in the picture and on earth."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.pursuit import TrackingStatus
from UAV.cameras.values import Pose
from typing import Any

CAMERA_TRACKING_GEO_STATUS: int
CAMERA_TRACKING_IMAGE_STATUS: int
def tracking_of(msg: Any, place: Pose | None = None) -> TrackingStatus:
    """What a camera tells

    Args:
        msg: A CAMERA_TRACKING_IMAGE_STATUS
        place: As from `place_of`
    """
def place_of(msg: Any) -> Pose | None:
    """Where the target is; `None`: not known

    Args:
        msg: A CAMERA_TRACKING_GEO_STATUS
    """

__all__ = ['tracking_of', 'place_of', 'CAMERA_TRACKING_GEO_STATUS', 'CAMERA_TRACKING_IMAGE_STATUS']
