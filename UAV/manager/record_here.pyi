"Keep the live stream of a camera in an MP4 on your own computer."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.camera_row import CameraRow
from UAV.video.recorder import Recorder
from pathlib import Path
from typing import Any

def file_name(name: str, began: float, part: int = 0) -> str:
    """The name of a recording

    Args:
        name: Of the camera
        began: s since 1970
        part: 0 is the first; another begins when the stream changes
    """
def free_path(folder: Path, name: str, began: float, part: int = 0) -> Path:
    """Where a recording can go, because there is no such file yet

    Args:
        folder: Where to
        name, began, part: As for `file_name`
    """

class Keeper(Recorder):
    "Records the stream of a camera"
    reserve_here: float
    sets: bytes
    began: Any
    name_of: Any
    folder: Path
    stream: Any
    tell: Any
    def __init__(self, row: CameraRow, tell: Any = ...) -> None:
        """
        Args:
            row: Of the camera
            tell: Called when the first picture is in the file, and when it ends by itself; on its thread
        """
    def path_of(self, part: int) -> Path:
        "The file of part `part`, from 1: a name that is free in the folder of the row"
    def put(self, unit: Any) -> None:
        "Take a unit, and return at once"
    def send(self, unit: Any) -> None:
        "Write a picture; raises `OSError`, which ends the recording"

__all__ = ['file_name', 'free_path', 'Keeper']
