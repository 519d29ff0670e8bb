"For tests of tracking: a camera that notes for each frame where the car really is, and how well two rectangles agree."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.sim import SimCamera
from UAV.cameras.sim_world import SimWorld
from typing import Any

def overlap(a: Any, b: Any) -> float:
    """What two rectangles share, of all that they cover: 0…1

    Args:
        a, b: Rectangles: left, top, right, bottom
    """
def seen_car(t: float, fov: float = 50.0, position: tuple = ..., attitude: tuple = ...) -> tuple:
    """A picture of 640 x 480 px, and the rectangle around the car: left, top, right, bottom, px

    Args:
        t: s
        fov: Horizontal field of view, degrees
        position: Of a camera: north, east, down, m
        attitude: Where it looks: roll, pitch, yaw, degrees
    """

class TruthCamera(SimCamera):
    "A `SimCamera` that notes for each frame where the car is in it"
    boxes: dict
    points: dict
    world: SimWorld
    def __init__(self, *args: Any, car_speed: float | None = None, **kwargs: Any) -> None:
        """
        Args:
            car_speed: m/s; `None`: as it always is
            kwargs: As for `SimCamera`
        """
    def view(self, look: Any = None, *args: Any) -> Any: ...
    def read(self) -> Any: ...
    def target_place(self, frame: Any, point: Any) -> Any: ...
    def around_car(self) -> dict:
        "The rectangle around the car in the next frame, as `camera_track_rectangle` wants it"
    def frame_of(self, status: Any) -> int:
        """The number of the frame that it is about

        Args:
            status: A `TrackingStatus` with a point
        """
    def beside_car(self, place: Any, number: int) -> float:
        """How far a place is from the middle of the car, m

        Args:
            place: A `Pose`
            number: Of a frame
        """

__all__ = ['overlap', 'seen_car', 'TruthCamera']
