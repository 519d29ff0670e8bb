"For tests: a ground station that finds gimbals, and has the buttons and the stick of QGroundControl's gimbal panel."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.testing.actor import Actor
from collections import Counter
from typing import Any


class SeenGimbal:
    "What a ground station knows of one gimbal"
    manager: int
    device_id: int
    information: Any
    status: Any
    attitude: Any
    asked: Counter
    def __init__(self, manager: int, device_id: int) -> None: ...
    @property
    def complete(self) -> bool:
        "Does the panel show it?"
    @property
    def device(self) -> int:
        "Component id of the device"
    @property
    def buttons(self) -> list:
        "The buttons that not every gimbal has"
    @property
    def holder(self) -> tuple | None:
        "(system, component) that is in control; `None` when it is free"
    def does(self, flag: str) -> bool:
        "Is the flag, such as 'RETRACT', in its report?"
    @property
    def pitch(self) -> float:
        "Degrees, up is positive"
    @property
    def yaw(self) -> float:
        "Degrees from the vehicle's nose"
    @property
    def compass(self) -> float | None:
        "Degrees from north; `None`, and no needle, without a frame flag or `delta_yaw`"

class GroundStation(Actor):
    "In the manner of QGroundControl: finds the gimbals of a vehicle, and moves them"
    may_ask: int
    has_autopilot: bool
    gimbals: dict
    dropped: list
    asked: Counter
    take_over: Any
    def __init__(
            self, connection: str, system: int = 255, component: int = 190, vehicle: int = 1, speed: float = 1.0,
    ) -> None:
        """
        Args:
            connection: As pymavlink takes it: 'udpout:127.0.0.1:14550'
            system: Our own system id
            component: Our own component id
            vehicle: System id of the vehicle
            speed: How many times faster than life
        """
    def on_heartbeat(self, m: Any) -> None:
        "Is its sender a gimbal manager? Ask it soon"
    def on_command_ack(self, m: Any) -> None:
        "The next may be asked"
    def on_gimbal_manager_information(self, m: Any) -> None:
        "What it can"
    def on_gimbal_manager_status(self, m: Any) -> None:
        "Who is in control"
    def on_gimbal_device_attitude_status(self, m: Any) -> Any:
        "Where it looks"
    def find_gimbal(self, manager: int = ..., timeout: float = 10.0) -> SeenGimbal:
        """Play until that gimbal is complete; raises `TimeoutError`, with what is missing

        Args:
            manager: Component id of its manager
            timeout: Seconds
        """
    def missing(self, manager: int) -> str:
        "Why the gimbal of this component is not shown"
    def acquire(self, gimbal: SeenGimbal) -> str:
        "Take control, and leave the secondary as it is"
    def release(self, gimbal: SeenGimbal) -> str:
        "Give control back"
    def point(self, gimbal: SeenGimbal, pitch: float, yaw: float) -> str:
        """A click into the picture

        Args:
            gimbal, pitch: Degrees
            yaw: Degrees from the nose
        """
    def center(self, gimbal: SeenGimbal) -> str:
        "The button Center"
    def point_absolute(self, gimbal: SeenGimbal, pitch: float, compass: float) -> str:
        """Look there, and stay there while the vehicle turns

        Args:
            gimbal, pitch: Degrees
            compass: Degrees from north
        """
    def switch_yaw_lock(self, gimbal: SeenGimbal, on: bool) -> str:
        "The yaw-lock switch: the present numbers, and no frame flag"
    def retract(self, gimbal: SeenGimbal, on: bool = True) -> str:
        "The button Retract"
    def turn(self, gimbal: SeenGimbal, pitch: float = 0.0, yaw: float = 0.0) -> bool:
        """Hold the stick there, until `turn` is called again

        Args:
            gimbal, pitch, yaw: Degrees a second; 0 and 0 lets the stick go
        """
    def look_at(self, lat: float, lon: float, alt: float, to: tuple | None = None) -> str:
        """ROI here

        Args:
            lat, lon: Degrees
            alt: Above mean sea level, m
            to: (system, component); `None` is the autopilot
        """
    def look_away(self, to: tuple | None = None) -> str:
        "Cancel ROI"

__all__ = ['SeenGimbal', 'GroundStation']
