"For tests: play a ground station or an autopilot that sends heartbeats, repeats itself and waits for answers."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.testing.peer import Peer
from collections import deque
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from typing import Any


class Actor(Peer):
    "A peer that plays a part, over any connection of pymavlink"
    address: tuple
    other: tuple
    inbox: deque
    mav: mavlink.MAVLink
    parser: mavlink.MAVLink
    connection: Any
    speed: float
    def __init__(
            self, connection: str, system: int = 255, component: int = 190, other: tuple = ..., speed: float = 1.0,
    ) -> None:
        """
        Args:
            connection: As pymavlink takes it: 'udpout:127.0.0.1:14550', '/dev/ttyUSB0,57600'
            system: Our own system id
            component: Our own component id
            other: (system, component) that our commands are for
            speed: How many times faster than life: with 10, a second takes a tenth of one
        """
    @property
    def now(self) -> float:
        "Seconds, on the clock of the part"
    def write(self, frame: bytes) -> None:
        "Send a frame"
    def close(self) -> None:
        "Close its connection"
    def every(self, seconds: float, job: Any) -> None:
        "Do `job()` at once, and again every `seconds`, until `stop`"
    def stop(self, job: Any) -> None:
        "Do it no more"
    def hear(self, data: bytes) -> None:
        "Give each message of `data` to its method: a HEARTBEAT to `on_heartbeat`"
    def from_other(self, msg: Any) -> bool:
        "Is it from the component that our commands are for?"
    def wait(self, name: str | None = None, fits: Any = ..., timeout: float = 10.0) -> Any:
        """The next message of this name that fits; raises `TimeoutError` when none comes

        Args:
            name: Of the message; `None` takes any
            fits: What else must be true of it
            timeout: Seconds
        """
    def command_int(
            self, command: str | int, *params: float, x: int = 0, y: int = 0, z: float = 0.0, frame: int = ...,
            to: tuple | None = None,
    ) -> Any:
        """A COMMAND_INT

        Args:
            command: A MAV_CMD, or its name without `MAV_CMD_`
            params: The first four; NaN for the rest
            x, y, z: The last three
            frame: Which MAV_FRAME they are in
            to: (system, component); `None` is `other`
        """
    def ask_int(self, command: str | int, *params: float, timeout: float = 10.0, **how: Any) -> str:
        "Send a command as `command_int` makes it, with `how`, and wait for its `result`"
def play(*actors: Actor, until: Any = None, seconds: float = 10.0) -> bool:
    """Let `actors` do and hear what they have to

    Args:
        until: Ends the play when it gives true
        seconds: How long at most, on the first actor's clock
    """
def q_of(roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> list:
    "`[w, x, y, z]` of an attitude in degrees, by pymavlink"
def wrapped(angle: float) -> float:
    "Degrees, as -180 ≤ angle < 180"
def angles_of(q: Any) -> tuple:
    "`(roll, pitch, yaw)` in degrees of `[w, x, y, z]`, from pymavlink's rotation matrix"
nothing: list
def flags_of(*names: str) -> int:
    "Gimbal flags by their names in GIMBAL_DEVICE_FLAGS"

__all__ = ['nothing', 'Actor', 'play', 'q_of', 'wrapped', 'angles_of', 'flags_of']
