"For tests: the other end of a link, made of a socket and pymavlink, with nothing of this package."
# Written by .ci/stubs.py from the live classes: do not edit.
import socket
from collections import deque
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from typing import Any
from typing_extensions import Self


class Peer:
    "The other end of a link: a socket, and pymavlink"
    address: tuple
    other: tuple
    inbox: deque
    mav: mavlink.MAVLink
    parser: mavlink.MAVLink
    sock: socket.socket
    def __init__(
            self, port: int | None = None, system: int = 255, component: int = 190, other: tuple = ..., kind: Any = ...,
            buffer: int = ...,
    ) -> None:
        """
        Args:
            port: Connect to this port of this machine; `None` listens on a free one (UDP)
            system: Our own system id
            component: Our own component id
            other: (system, component) that our commands are for
            kind: UDP, or `SOCK_STREAM` for TCP
            buffer: That the system keeps for us of what arrives, bytes
        """
    def close(self) -> None:
        "Close its socket"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def port(self) -> int:
        "Our own port on this machine"
    def pack(self, msg: Any, source: tuple | None = None, **how: Any) -> bytes:
        """`msg` as a frame, with our next sequence number

        Args:
            msg: A message, as `mav.…_encode` makes it
            source: (system, component) in whose name; `None` is our own
            how: For pymavlink's `pack`: `force_mavlink1=True`
        """
    def write(self, frame: bytes) -> None:
        "Send a frame"
    def send(self, msg: Any, source: tuple | None = None) -> None:
        "Send a message, in the name of `source`"
    def beat(self, mav_type: int = ...) -> None:
        "Send a HEARTBEAT"
    def command(self, command: str | int, *params: float, to: tuple | None = None, confirmation: int = 0) -> Any:
        """A COMMAND_LONG

        Args:
            command: A MAV_CMD, or its name without `MAV_CMD_`
            params: Up to seven; 0 for the rest
            to: (system, component); `None` is `other`
            confirmation: One higher with each repetition
        """
    def hear(self, data: bytes) -> None:
        "Put the messages of `data` into the inbox"
    def wait(self, name: str | None = None, fits: Any = ..., timeout: float = 10.0) -> Any:
        """The next message of this name that fits; raises `TimeoutError` when none comes

        Args:
            name: Of the message, for example 'HEARTBEAT'; `None` takes any
            fits: What else must be true of it
            timeout: Seconds
        """
    async def next(self, name: str | None = None, fits: Any = ..., timeout: float = 5.0) -> Any:
        """As `wait`, for a cell in which others must run meanwhile

        Args:
            name: Of the message; `None` takes any
            fits: What else must be true of it
            timeout: Seconds
        """
    def result(self, command: int, timeout: float = 10.0) -> str:
        "What the other end says to `command` in the end, a MAV_RESULT; raises `TimeoutError` when nothing comes"
    def ask(self, command: str | int, *params: float, timeout: float = 10.0, **how: Any) -> str:
        "Send a command as `command` makes it, with `how`, and wait for its `result`"
    def sign(self, key: bytes, link_id: int = 0, age: float = 0.0) -> Self:
        """Sign all that is sent from now on, as in MAVLink's message signing, and drop what is not signed so

        Args:
            key: 32 bytes
            link_id: 0 to 255
            age: Our clock is late by this, seconds
        """
def free_port() -> int:
    "A port of this machine that is not in use, for programs that cannot choose one themselves"

__all__ = ['Peer', 'free_port']
