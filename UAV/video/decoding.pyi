"Get decoded pictures from a URL: live, with no picture held back, or from a file at its own speed."
# Written by .ci/stubs.py from the live classes: do not edit.
import numpy as np
from collections.abc import Generator
from functools import cached_property
from typing import Any


class PlayerError(OSError):
    "There is no such video"
receivers: dict
def url_name(url: Any) -> str:
    """The URL for people: without user and password

    Args:
        url: As `open_pictures` takes it
    """

class Decoded:
    "A decoded picture"
    decoded: Any
    number: int
    time: float
    time_utc: float
    size: tuple
    def __init__(self, decoded: Any, number: int, time: float, time_utc: float) -> None:
        """
        Args:
            decoded: `av.VideoFrame`
            number: Counts the pictures of a player
            time: When it arrived, monotonic s; in a file, when it is due
            time_utc: When it was taken, if the sender says so (RTCP), else when it came; s since 1970
        """
    @cached_property
    def image(self) -> Any:
        "BGR, `uint8`"
    def scaled(self, width: int, height: int) -> np.ndarray:
        """The picture in another size, BGR, `uint8`; threads may ask at the same time

        Args:
            width: px
            height: px
        """

class LivePictures:
    "The pictures of a receiver"
    receiver: Any
    sinks: list
    def __init__(self, receiver: Any) -> None:
        """
        Args:
            receiver: A `Receiver`
        """
    def pictures(self) -> Generator[Any, None, None]:
        "`(av.VideoFrame, time, time_utc)` of each; raises `OSError`"
    def __getattr__(self, name: str) -> Any: ...

class FilePictures:
    "The pictures of a file"
    connects: bool
    port: Any
    lost: int
    def __init__(self, path: str, paced: bool) -> None:
        """
        Args:
            path: Of the file; raises `PlayerError` when it is no video
            paced: In its own time?
        """
    def stop(self) -> None:
        "End `pictures`, from any thread"
    def close(self) -> None:
        "Give the file back; not while another thread reads"
    def pictures(self) -> Generator[Any, None, None]:
        "`(av.VideoFrame, time, time_utc)` of each; raises `Stopped`"
def open_pictures(url: Any, timeout: float = 5.0, paced: bool = True, transport: str | None = None) -> Any:
    """What gives the pictures of `url`; raises `ValueError` or `PlayerError`

    Args:
        url: See the table above
        timeout: s that a stream may be silent
        paced: Is a file played in its own time?
        transport: Of RTSP: 'tcp' or 'udp'
    """

__all__ = ['receivers', 'PlayerError', 'url_name', 'Decoded', 'LivePictures', 'FilePictures', 'open_pictures']
