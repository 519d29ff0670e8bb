"Draw a rectangle, let the camera follow what is in it, and see where it is now."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.camera_row import CameraRow
from typing import Any

def target_of(msg: Any, ratio: float = ...) -> dict | None:
    """State and rectangle of a target, as parts of the picture; `None` when nothing is tracked, or no place is known

    Args:
        msg: A CAMERA_TRACKING_IMAGE_STATUS
        ratio: Width of the picture by its height
    """
def target_shown(row: CameraRow) -> dict | None:
    """Where the target of a camera is now, as `target_of`

    Args:
        row: Of the panel
    """
async def keep_following(row: CameraRow) -> None:
    "Begin to follow when there is a target and a viewer"

__all__ = ['target_of', 'target_shown', 'keep_following']
