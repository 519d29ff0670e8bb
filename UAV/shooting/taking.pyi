"Take pictures and record from a shell: pictures that the camera has announced, recordings that end when they should."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.dialect import MAVError
from pathlib import Path
from typing import Any

def free_place(folder: Any, path: str) -> Path:
    """A file in `folder` that does not exist yet, named as it is on the camera; raises `ValueError` for a strange name

    Args:
        folder: Where a file is to go
        path: Its path or URL on the camera
    """
def folder_here(folder: Any) -> Path:
    """A folder where files can be written; raises `ValueError` for one where they cannot, `OSError` for a full disk

    Args:
        folder: That was typed after `--to`; it is made
    """

class NotTaken(MAVError):
    "Not all that was asked for was taken"
def pictures(text: str) -> Any: ...
def pause(text: str) -> Any: ...
async def snap(shooting: Any, count: Any = 1, every: Any = 0.0, to: str | None = None) -> None:
    """Take pictures, and wait until each is announced

    Args:
        count: How many; 0: until Ctrl-C
        every: s between two pictures; 0: as fast as the camera can
        to: Folder here, where the files are to go
    """
async def record(shooting: Any, seconds: Any = None, stream: Any = 0) -> Any:
    """Record video, in the camera; Ctrl-C stops it at once

    Args:
        seconds: How long, s; without it, until it is told to `stop`
        stream: Which stream; 0: all
    """
async def stop_all(shooting: Any) -> None:
    "Stop what the camera is taking: the series of pictures, and the recording"

__all__ = ['pictures', 'pause', 'free_place', 'folder_here', 'NotTaken', 'snap', 'record', 'stop_all']
