"Motors and a camera that obey Viewsheen's frames as the maker's document says."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.viewsheen_frames import Command, Report
from dataclasses import dataclass
from typing import Any


@dataclass
class SimulatedCamera:
    "What the camera of the device is doing"
    zoom: float = ...
    zooming: int = ...
    focus: str = ...
    recording: bool = ...
    shots: list = ...
    every: float = ...
    tracking: tuple | None = ...

class ViewsheenDevice:
    "What a Viewsheen gimbal camera does with its commands"
    step: float
    rate_lasts: float
    most: int
    orders: dict
    clock: Any
    fed: bool
    zoom: float
    motors: dict
    targets: dict
    mode: int
    heading: float
    earth: bool
    camera: SimulatedCamera
    heard: list
    def __init__(self, clock: Any = ..., fed: bool = False, zoom: float = 3.5) -> None:
        """
        Args:
            clock: Gives seconds
            fed: Does it hear the autopilot's attitude? Then it can measure yaw from north
            zoom: Greatest magnification
        """
    def advance(self) -> None:
        "Move on to now"
    @property
    def angles(self) -> tuple:
        "Pitch from the horizon and yaw from the nose, degrees"
    @property
    def turning(self) -> bool:
        "Does it move?"
    def obey(self, command: Command) -> None:
        "Do as told; unknown commands are passed over"
    def report(self) -> Report:
        "What the device would report now"
def point(device: Any, **angles: Any) -> None:
    "Go to these angles"

__all__ = ['SimulatedCamera', 'ViewsheenDevice', 'point']
