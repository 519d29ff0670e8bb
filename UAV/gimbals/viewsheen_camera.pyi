"Zoom, focus, take pictures and films, and track with a Viewsheen gimbal camera."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass


@dataclass
class Series:
    "Pictures that we take one by one"
    interval: float
    left: float
    due: float
def as_camera_does(interval: float, count: int) -> bytes | None:
    """The frame for pictures that the camera takes by itself; `None`: it cannot

    Args:
        interval: s between pictures
        count: 0 until stopped
    """

__all__ = ['Series', 'as_camera_does']
