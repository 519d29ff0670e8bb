"Record an MP4 that can be played at any moment: while it grows, after `kill -9`, and when the disk is full."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.units import AccessUnit, Sink
from pathlib import Path
from typing import Any
from typing_extensions import Self


class SafeFile:
    "A new file that only grows; what must be corrected in it is written last"
    path: Path
    size: Any
    fault: OSError | Any
    def __init__(self, path: Any) -> None:
        """
        Args:
            path: Where it shall be; made with the first bytes
        """
    def tell(self) -> Any:
        "Where the next bytes go"
    def seek(self, offset: int, whence: int = 0) -> int:
        """Go there; the next bytes are a correction, unless that is the end

        Args:
            offset: bytes
            whence: From the beginning (0), from here (1), or from the end (2)
        """
    def mark(self) -> None:
        "What is there now makes sense without what comes"
    def write(self, data: Any) -> int:
        "Raises `OSError` once; after that nothing is written, and nothing is raised"
    def sync(self) -> None:
        "Wait until it is on the disk"
    def close(self) -> None:
        "Write the corrections, unless something went wrong before; raises `OSError`"
    def is_there(self) -> bool:
        "Is our file still found under its name?"

class MP4File:
    "A video file that can be played at any time while it grows"
    flags: str
    fragment: float
    path: Path
    format: Any
    began: Any
    seconds: Any
    file: SafeFile
    def __init__(self, path: Any, unit: AccessUnit) -> None:
        """
        Args:
            path: Of a file that is not there yet
            unit: The first one, a key picture; `write` it, too
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def bytes(self) -> int:
        "How large the file is"
    def write(self, unit: AccessUnit) -> None:
        "Add a picture; raises `OSError`"
    def close(self) -> None:
        "Make a plain MP4 of it; raises `OSError` when that cannot be, and then it stays as it was"

class DiskFull(OSError):
    "There is no room for more of a recording"

class Recorder(Sink):
    "Writes access units to MP4 files that survive a crash"
    most: int
    segment: float
    quota: float | None
    reserve: float
    on_end: Any
    interval: float
    videos: list
    dropped: Any
    def __init__(
            self, name: Any, segment: float = 60.0, quota: float | None = None, reserve: float = 100.0, on_end: Any = None,
            interval: float = 1.0,
    ) -> None:
        """
        Args:
            name: Function that gives the path of segment n, from 0
            segment: s, then the next key picture begins a new file
            quota: MiB that it may fill; `None` is the whole disk
            reserve: MiB of the disk that stay free, for pictures
            on_end: Called with the recorder when it ends by itself; `fault` says why
            interval: s between two looks at the disk, each of which waits until all is written
        """
    @property
    def files(self) -> list:
        "The paths of all segments"
    @property
    def seconds(self) -> float:
        "How much is recorded"
    @property
    def bytes(self) -> int:
        "What it takes on the disk"
    def send(self, unit: AccessUnit) -> None:
        "Write a picture; raises `OSError`, which ends the recording"
    def end(self) -> None:
        "Close the file, and tell when the recording has ended by itself"

__all__ = ['SafeFile', 'MP4File', 'DiskFull', 'Recorder']
