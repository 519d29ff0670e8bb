"For tests: an autopilot that finds a gimbal device and steers it fifty times a second, as ArduPilot does."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.testing.actor import Actor
from typing import Any


class Autopilot(Actor):
    "In the manner of ArduPilot: finds a gimbal device, and steers it"
    period: float
    follow_flags: int
    lock_flags: int
    boot: Any
    flight: Any
    gimbal: Any
    attitude: Any
    heard_at: Any
    orders: list
    other: tuple
    def __init__(self, connection: str, system: int = 1, component: int = ..., up: float = 0.0, speed: float = 1.0) -> None:
        """
        Args:
            connection: As pymavlink takes it: 'udpout:127.0.0.1:14550'
            system: Our own system id, and the gimbal's
            component: Our own component id
            up: Seconds since it was switched on
            speed: How many times faster than life
        """
    @property
    def up(self) -> float:
        "Seconds since it was switched on"
    def on_heartbeat(self, m: Any) -> None:
        "A gimbal?"
    def on_gimbal_device_information(self, m: Any) -> None:
        "Begin to steer it"
    def on_gimbal_device_attitude_status(self, m: Any) -> None:
        "Where it looks"
    def point(self, pitch: float, yaw: float, lock: bool = False) -> None:
        """Look there

        Args:
            pitch, yaw: Degrees
            lock: Is `yaw` from north, and held there? Else it is from the nose
        """
    def turn(self, pitch: float, yaw: float, lock: bool = False) -> None:
        """Turn, until another order

        Args:
            pitch, yaw: Degrees a second
            lock: Does the yaw stay when it is 0 and the vehicle turns?
        """
    def retract(self) -> None:
        "Retract, in the form in which ArduPilot says it"
    @property
    def healthy(self) -> bool:
        "Does the gimbal pass the check before take-off?"
    @property
    def looks(self) -> tuple:
        "`(pitch, yaw)` of the gimbal as it reports them, degrees; yaw from the nose"

__all__ = ['Autopilot']
