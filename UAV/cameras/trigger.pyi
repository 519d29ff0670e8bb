"`Trigger` takes a picture every few metres with a camera that knows where it is, and tells when it cannot."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import CameraBusy
from UAV.utils.values import Value
from dataclasses import dataclass
from typing import Any


class PlaceUnknown(CameraBusy):
    "By distance, and it is not known where the camera is; it may be soon"

@dataclass(frozen=True, repr=False, eq=False)
class TriggerStatus(Value):
    "Whether pictures are taken by distance; comes when that changes"
    distance: float = ...
    state: str = ...
    count: int = ...
    why: str = ...

class Trigger:
    "Has a camera take pictures by distance"
    period: float
    too_late: float
    camera: Any
    clock: Any
    rule: Any
    job: Any
    status: TriggerStatus
    shot: Any
    def __init__(self, camera: Any, clock: Any = ...) -> None:
        """
        Args:
            camera: Its `pose`, `velocity`, `captures`, `min_interval`, `image_start_capture` and `announce` are used
            clock: Gives seconds
        """
    def place(self) -> tuple | None:
        "Latitude, longitude (degrees), and velocity to the north and to the east (m/s); `None`: not known"
    @property
    def distance(self) -> float:
        "Between two pictures, m; NaN when it is off"
    def tell(self, state: str, why: str = '') -> None:
        "Announce a `TriggerStatus`, when it is another state or there is something to say"
    def tick(self) -> Any:
        "Look where the camera is, and take a picture if one is due"
    def start(self, distance: float, now: bool = False) -> None:
        """Begin; raises `ValueError`, `PlaceUnknown`, and with `now` what a picture raises

        Args:
            distance: m
            now: Take the first picture at once, and not after the first distance?
        """
    def stop(self, why: str = '') -> None:
        "Take no more pictures; may be called twice"
    def count_from_0(self) -> None:
        "Forget how many pictures there were"

__all__ = ['PlaceUnknown', 'TriggerStatus', 'Trigger']
