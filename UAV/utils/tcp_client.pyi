"A TCP connection to a device that is not always there: opened in the background, and opened again when it is lost."
# Written by .ci/stubs.py from the live classes: do not edit.
import socket
from logging import Logger
from typing import Any
from typing_extensions import Self

log: Logger
def retry_delay(attempt: int, first: float = 0.25, most: float = 8.0) -> float:
    """How long to wait before this attempt to connect

    Args:
        attempt: 0 is the first
        first, most: s
    """
def watch_peer(sock: Any, after: int = 5) -> None:
    """Small packets at once, and an error when the other side has vanished

    Args:
        sock: A TCP socket
        after: s of silence after which the other side counts as gone
    """

class TCPClient:
    "A TCP connection that is made in the background, and made again when it is lost"
    patience: float
    steady: float
    buffer: int
    host: str
    port: int
    hear: Any
    changed: Any
    error: str | Any
    up: bool
    def __init__(self, host: str, port: int, hear: Any = ..., changed: Any = ...) -> None:
        """
        Args:
            hear: Called with the bytes that come
            changed: Called when it is there, and when it is lost
        """
    def start(self) -> None:
        "Begin to connect"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def wait_up(self, up: bool = True, timeout: float = 10.0) -> bool:
        "Wait until it is connected, or is not, `timeout` seconds at most"
    def send(self, data: bytes) -> bool:
        """Send it now, or not at all: is it on its way?

        Args:
            data: A whole frame
        """
    def drop(self, why: Any) -> bool:
        """Give this connection up, and make a new one

        Args:
            why: For the log, and `error`
        """
    def close(self) -> None:
        "Close it for good; may be called twice"

__all__ = ['log', 'retry_delay', 'watch_peer', 'TCPClient']
