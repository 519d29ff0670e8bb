"Give any link the losses, delays and outages of a bad radio, the same ones on every run."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.wire.links import Link
from collections.abc import Sequence
from logging import Logger
from typing import Any

log: Logger

class LossyLink(Link):
    "Wraps a link, and treats what passes like a bad radio does; the same seed brings the same fate"
    buffer: int
    hold: float
    most: int
    loss: float
    duplicate: float
    reorder: float
    bit_errors: float
    latency: float
    jitter: float
    baudrate: float | None
    outages: Any
    seed: int | str
    link: Any
    outgoing: Direction
    incoming: Direction
    up: bool
    opened: Any
    def __init__(
            self, link: Link | str, loss: float = 0.0, duplicate: float = 0.0, reorder: float = 0.0, latency: float = 0.0,
            jitter: float = 0.0, baudrate: float | None = None, outages: Any = ..., bit_errors: float = 0.0,
            seed: int | str = 0,
    ) -> None:
        """
        Args:
            link: The link to wrap, or the connection string of one
            loss: Probability that a frame is lost
            duplicate: Probability that it comes twice
            reorder: Probability that it comes after the next one
            latency: Seconds that every frame takes
            jitter: Seconds that it may take longer
            baudrate: Of the line, 10 bits a byte; `None` is no limit. (A serial port inside has its own)
            outages: Periods `(start, end)` in which nothing passes, seconds since now
            bit_errors: Probability that a bit is flipped
            seed: For the dice
        """
    def __getattr__(self, name: Any) -> Any: ...
    def write(self, data: bytes, peer: Any = None) -> None: ...
    def recv(self) -> Any: ...
    def close(self) -> None:
        "Wake a waiting `recv`, and end our threads; safe to call twice"
    def release(self) -> None: ...
    def welcome(self, peer: Any) -> None: ...
    def gone(self, peer: Any) -> bool: ...
    def reopen(self) -> None: ...

class Direction:
    "What becomes of the frames that go one way, and when they come out"
    counted: Sequence
    link: LossyLink
    name: str
    dice: Any
    waiting: list
    late: list
    changed: threading.Condition
    damaged: Any
    duplicated: Any
    reordered: Any
    def __init__(self, link: LossyLink, name: str) -> None: ...
    def put(self, data: bytes, peer: Any, now: float) -> None:
        "Throw the dice for a frame that comes in at `now`, and line up what is left of it"
    def pop(self, now: float) -> tuple | None:
        "`(data, peer)` of the next frame that is due; `None` when there is none yet"
    def wait(self) -> None:
        "Wait until the next frame is due, or something has changed; with `changed` held"
def cut(buf: bytes) -> tuple:
    "`(frames, rest)`: the frames in `buf`, damaged ones as well, and the beginning of one that is not complete"

__all__ = ['log', 'LossyLink', 'Direction', 'cut']
