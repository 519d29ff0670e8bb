"See what a camera is, how it is, and what it tells by itself."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

async def list_cameras(shooting: Any) -> None:
    "Which cameras there are, and what else was heard"
def information_text(info: Any) -> str:
    """What a camera is, for people: some lines

    Args:
        info: A CAMERA_INFORMATION
    """
def information_object(info: Any) -> dict:
    """The same for programs; lengths in mm

    Args:
        info: A CAMERA_INFORMATION
    """
async def camera_info(shooting: Any) -> None:
    "What the camera is, what it can do, and how wide it sees"
def doing_text(doing: dict) -> str:
    """What a camera is doing, for people

    Args:
        doing: As `capture_of` gives it
    """
def settings_text(settings: dict) -> str:
    """How a camera is set, for people

    Args:
        settings: As `settings_of` gives it
    """
async def camera_status(shooting: Any, watch: bool = False) -> None:
    """How the camera is: mode, zoom, what it is doing, how many pictures, how much room

    Args:
        watch: Once a second, until Ctrl-C
    """
def stream_number(text: str) -> Any: ...
async def video_streams(shooting: Any, start: Any = None, stop: Any = None) -> None:
    """The video streams, and where to watch them

    Args:
        start: Start this one first
        stop: Stop this one first
    """
def picture_text(msg: Any) -> str:
    """A picture, for people

    Args:
        msg: A CAMERA_IMAGE_CAPTURED
    """
def picture_object(msg: Any) -> dict:
    """The same for programs; degrees and metres, time in s since 1970

    Args:
        msg: A CAMERA_IMAGE_CAPTURED
    """
async def watch_camera(shooting: Any) -> None:
    "What the camera tells by itself, until Ctrl-C: pictures, settings, storage, texts"

__all__ = [
    'stream_number', 'list_cameras', 'information_text', 'information_object', 'camera_info', 'doing_text',
    'settings_text', 'camera_status', 'video_streams', 'picture_text', 'picture_object', 'watch_camera',
]
