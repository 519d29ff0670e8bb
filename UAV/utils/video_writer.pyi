"Write frames into a video file, and play a video in a notebook."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any
from typing_extensions import Self


class VideoWriter:
    "Write frames to a video file"
    filename: Path
    fps: float
    rgb2bgr: bool
    codec: str
    frames: int
    size: Any
    def __init__(
            self, filename: str = '_autoplay.mp4', fps: float = 30.0, rgb2bgr: bool = False, codec: str = 'mp4v',
    ) -> None:
        """
        Args:
            filename: File to write; a notebook shows one of this name at the end of its `with`
            fps: Frames in a second
            rgb2bgr: The frames are RGB: swap red and blue
            codec: Four letters, as OpenCV and FFmpeg name it
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def add(self, img: Any) -> None:
        """Append a frame; raises `OSError` when the file cannot be written and `ValueError` when the size changes

        Args:
            img: Picture, see `as_bgr`; all of one size
        """
    def close(self) -> None:
        "Finish the file"
    def show(self, width: int = 320) -> Any:
        """Finish the file and show it: a player in a notebook, its name in a terminal

        Args:
            width: Of the player, pixels
        """

class Video:
    "A short video that shows itself: a player in a notebook, its name in a terminal"
    filename: Path
    width: int
    data: Any
    frames: Any
    def __init__(self, filename: Any, width: int = 320) -> None:
        """
        Args:
            filename: Any file that OpenCV reads
            width: Of the player, pixels
        """

__all__ = ['VideoWriter', 'Video']
