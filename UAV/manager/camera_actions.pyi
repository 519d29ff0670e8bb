"Pictures, recordings, mode, zoom, focus and stream: each button is one marked method, and says what came of it."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.camera_row import CameraRow
from UAV.manager.helm import Helm
from typing import Any

def in_or_out(what: str, value: Any) -> int:
    "`value`; raises `ValueError` unless it is 1 (in) or -1 (out)"

class ZoomHelm(Helm):
    "Zooms while a button is held"
    what: str
    most: float
    locked: Any
    row: CameraRow
    insisting: Any
    def __init__(self, row: CameraRow) -> None:
        """
        Args:
            row: Of the camera
        """
    async def leave(self) -> None:
        "Zoom no more, and tell it to no camera any more"

__all__ = ['in_or_out', 'ZoomHelm']
