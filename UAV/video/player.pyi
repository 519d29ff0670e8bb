"Watch a live stream: the newest picture, decoded, from a source that may vanish and come back."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
import threading
from UAV.utils.pictures import Thumbnail
from UAV.video.decoding import Decoded
from collections import deque
from collections.abc import Generator
from contextlib import nullcontext
from typing import Any
from typing_extensions import Self


class _Pictures:
    "Decoded pictures, between the thread that decodes and those who wait"
    most: int
    newest: bool
    over: bool
    last: Decoded | Any
    count: int
    given: Any
    frames: deque
    waiting: list
    changed: threading.Condition
    def __init__(self, newest: bool) -> None:
        """
        Args:
            newest: Keep only the newest?
        """
    def wake(self) -> None:
        "Wake all who wait; inside `changed`"
    def put(self, picture: Any, came: float, utc: float) -> None:
        """Another one; raises `Stopped` when all is over

        Args:
            picture: `av.VideoFrame`
            came: When it arrived, monotonic s
            utc: When it was taken, s since 1970
        """
    def end(self, forget: bool = False) -> None:
        "No more of them come; those that lie here can still be had, unless you `forget` them"
    def take(self) -> Decoded | None:
        "The next picture, `None` when there is none yet"
    def later(self, after: int) -> Decoded | None:
        """The newest picture, when it is later than `after`

        Args:
            after: The number of a picture
        """
    def wait(self, find: Any, timeout: float | None) -> Any:
        """What `find` finds; `None` when that takes too long, or all is over

        Args:
            find: `take`, or a function like it
            timeout: s; `None` waits as long as it takes
        """
    async def wait_async(self, find: Any) -> Any:
        "As `wait`, for an event loop; one call into the loop for each picture"

class Player:
    "Watch a live stream, or a file"
    first_retry: float
    last_retry: float
    url: Any
    fault: Any
    connected: bool
    log: logging.Logger
    def __init__(self, url: Any, timeout: float = 5.0, newest: bool = True, transport: str | None = None) -> None:
        """
        Args:
            url: As `open_pictures` takes it
            timeout: s without a packet after which the stream counts as lost
            newest: Only the newest picture? `False` hands out each, and plays a file as fast as you read
            transport: Of RTSP: 'tcp' or 'udp'; `None` is TCP, or UDP when the server refuses that
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "Stop, within a second; may be called twice"
    def read(self, timeout: float | None = None) -> Decoded | None:
        """The next picture; `None` when none comes in time, the file is at its end, or the player is closed

        Args:
            timeout: s to wait for it; `None` waits until there is one
        """
    def next(self, after: int = -1, timeout: float | None = None) -> Decoded | None:
        """The newest picture later than `after`, as a source gives it; `None` as for `read`

        Args:
            after: The number of the last picture seen
            timeout: s to wait; `None` waits until there is one
        """
    def watching(self) -> nullcontext:
        "For a `with`, as a source of frames has it: a player plays all the time"
    def __iter__(self) -> Generator[Any, None, None]: ...
    def __aiter__(self) -> Self: ...
    async def __anext__(self) -> Any: ...
    @property
    def newest(self) -> bool:
        "Does it hand out only the newest picture?"
    @property
    def ended(self) -> bool:
        "Will no picture come any more?"
    @property
    def size(self) -> tuple | None:
        "(width, height) of the newest picture, pixels"
    @property
    def port(self) -> int | None:
        "The UDP port on which it listens"
    @property
    def lost(self) -> int:
        "How many pictures came in part only, since the stream was last lost"
    @property
    def sinks(self) -> list:
        "Add a `Sink` to these, and it gets each access unit of a live stream as it came, to record it for example"
def strip(
        player: Any, count: int = 6, every: float = 0.5, width: int = 160, columns: int = 6, patience: float = 5.0,
) -> Thumbnail:
    """The next seconds of a stream in a row of small pictures, with their times; raises `PlayerError` when none comes

    Args:
        player: `Player`
        count: Pictures
        every: s between them
        width: Of each, pixels
        columns: In a row
        patience: s to wait for the first picture
    """

__all__ = ['Player', 'strip']
