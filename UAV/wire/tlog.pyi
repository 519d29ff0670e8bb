"Write what passes on a link into a `.tlog`, read the files of other programs, and play one as if it were a link."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.wire.links import Link
from collections.abc import Generator, Sequence
from logging import Logger
from pathlib import Path
from typing import Any

log: Logger
def is_secret(frame: bytes) -> bool:
    "Does `frame` carry a key (SETUP_SIGNING)? Such a frame is not kept"
def unsigned(frame: bytes) -> bytes:
    """`frame` as it is without a signature

    Args:
        frame: MAVLink 1 or 2, signed or not; the signature itself may be cut off already
    """
def without_secrets(frame: bytes) -> bytes | None:
    "What a log may hold of `frame`: not a signature (see `unsigned`), and nothing of a key"
def record(when: float, frame: bytes) -> bytes:
    """Time and frame, as they stand in a `.tlog`

    Args:
        when: Seconds since 1970
        frame: Whole; a signature is left out
    """
def read_tlog(file: Any) -> Generator[Any, None, None]:
    """What is in a `.tlog`, read as it is needed, without keys and signatures; raises `ValueError` when it is none

    Args:
        file: A `.tlog`
    """

class TlogWriter:
    "Appends records to a `.tlog` from a thread of its own; raises `ValueError` for a file that is none"
    period: float
    most: int
    path: Path
    lost: int
    def __init__(self, file: Any) -> None: ...
    def add(self, when: float, frame: bytes) -> None:
        """Have `frame` written soon; quick, and from any thread

        Args:
            when: Seconds since 1970
            frame: Whole
        """
    def close(self) -> None:
        "Write what waits, and close the file; safe to call twice"

class ReplayLink(Link):
    "`tlog:FILE`: what was logged comes again"
    prefixes: Sequence
    longest_silence: float
    name: str
    speed: float | None
    ended: threading.Event
    def __init__(self, name: str, baudrate: int = 0, speed: float | None = 1.0) -> None:
        """
        Args:
            name: Path of a `.tlog`
            baudrate: As all links have it; of no use here
            speed: Times as fast as it was; 0 or `None`: as fast as it can be read
        """
    def write(self, data: Any, peer: Any = None) -> Any:
        "There is no other end"
    def close(self) -> None: ...
    def release(self) -> None: ...
    def recv(self) -> tuple:
        "The next frame, when it is time; `None` when the link is closed"

__all__ = ['log', 'is_secret', 'unsigned', 'without_secrets', 'record', 'read_tlog', 'TlogWriter', 'ReplayLink']
