"Track a point or a rectangle, and learn where the target is, in the picture and on the ground."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import Pose

steepness: float
def replace_place(pose: Pose, north: float, east: float) -> Pose:
    "The place on the ground, so many metres from `pose`"

__all__ = ['steepness', 'replace_place']
