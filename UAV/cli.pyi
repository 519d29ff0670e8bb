"The shortest way to a MAVLink camera that works: `uav-demo` finds a camera, takes five pictures, and shows them."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any

def picture_line(msg: Any) -> str:
    """One line about a picture that was taken

    Args:
        msg: A CAMERA_IMAGE_CAPTURED
    """
async def demo(camera: Any, count: int = 5, say: Any = ...) -> list:
    """Serve `camera`, find it, and take `count` pictures; their CAMERA_IMAGE_CAPTURED

    Args:
        camera: A Camera
        count: How many pictures
        say: Where the lines go
    """
def save_sheet(folder: Any, images: list) -> Path:
    """Write `contact_sheet.jpg` beside the pictures; its path. `CameraError` when no picture could be taken

    Args:
        folder: Where the pictures are, and the sheet will be
        images: Their CAMERA_IMAGE_CAPTURED
    """
def uav_demo(video: str | None = None, out: str = 'uav_pictures', count: int = 5) -> None:
    """Find a MAVLink camera, take pictures, put them on a sheet. For example: `uav-demo --video flight.mp4 --out flight`

    Args:
        video: A video file, device or URL to use as the camera, in place of the simulated world
        out: Folder for the pictures
        count: How many pictures
    """

__all__ = ['picture_line', 'demo', 'save_sheet', 'uav_demo']
