"Links that are streams of bytes, which can be full, cut anywhere, and break."
# Written by .ci/stubs.py from the live classes: do not edit.
import socket
from UAV.wire.links import Link
from collections.abc import Sequence
from typing import Any


class Outbox:
    "Sends what it can without waiting, and the rest as soon as there is room"
    most: int
    device: Any
    send: Any
    kept: Any
    def __init__(self, device: Any, send: Any) -> None:
        """
        Args:
            device: A socket, a file descriptor, or what has a `fileno`
            send: Function that sends some of its bytes, and says how many; `BlockingIOError`: it would have to wait
        """
    def write(self, data: bytes) -> None:
        "Send `data`, now or when there is room; dropped when more than `most` bytes are kept already"
    def close(self) -> None:
        "Forget the rest, and end the thread"

class StreamLink(Link):
    "A link with one device; its `_open` makes the device and the `_outbox`"
    name: str
    baudrate: int
    def __init__(self, name: str, baudrate: int = 57600) -> None: ...
    def write(self, data: bytes, peer: Any = None) -> None: ...
    def release(self) -> None: ...
    def reopen(self) -> Any:
        "Open the device once more; raises `LinkError` when it is not there, or after `close`"

class TCPOut(StreamLink):
    "`tcp:HOST:PORT`: a client"
    prefixes: Sequence
    sock: socket.socket
    def recv(self) -> Any: ...
    def close(self) -> None: ...

class Client:
    "One client of a TCP server"
    sock: socket.socket
    outbox: Outbox
    heard: Any
    is_welcome: bool
    def __init__(self, sock: socket.socket) -> None: ...
    def close(self) -> None:
        "End the connection"

class TCPIn(Link):
    "`tcpin:HOST:PORT`: a server; what is for all goes to all its clients"
    prefixes: Sequence
    most: int
    sock: socket.socket
    clients: set
    def __init__(self, name: str, baudrate: int = 0) -> None: ...
    @property
    def port(self) -> int:
        "Our own port"
    def recv(self) -> Any: ...
    def write(self, data: bytes, peer: Client | None = None) -> None: ...
    def gone(self, peer: Client) -> bool: ...
    def close(self) -> None: ...
    def release(self) -> None: ...
    def welcome(self, peer: Client) -> None: ...

class SerialLink(StreamLink):
    "A serial port, `DEVICE` or `DEVICE,BAUDRATE`"
    prefixes: Sequence
    port: Any
    def recv(self) -> Any: ...
    def close(self) -> None: ...
def serial_trouble(name: str, error: Exception) -> str:
    """Why a serial port cannot be opened, in one sentence

    Args:
        name: What was to be opened
        error: pyserial's
    """

__all__ = ['Outbox', 'StreamLink', 'TCPOut', 'Client', 'TCPIn', 'SerialLink', 'serial_trouble']
