"`Codec` turns pictures into H.264 or H.265, with a hardware encoder where one really works on this machine."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.units import VideoFormat
from collections.abc import Generator
from typing import Any

def even(size: Any) -> tuple:
    """The largest size that encoders take in this one; at least 16×16

    Args:
        size: (width, height), px
    """
def fitted(image: Any, width: int, height: int) -> Any:
    """Scaled, but an odd last row or column falls off instead

    Args:
        image: BGR picture
        width: px, even
        height: px, even
    """

class Planes:
    "A picture as encoders take it (ITU-R BT.601, limited range); painted over and over again"
    picture: Any
    def __init__(self, width: int, height: int) -> None:
        """
        Args:
            width: px, even
            height: px, even
        """
    def arrays(self) -> list:
        "Y, U and V, to write in"
    def paint(self, image: Any) -> Any:
        """Convert `image`

        Args:
            image: BGR picture of that size
        """
def sensible_bitrate(width: int, height: int, rate: float, codec: str = 'h264') -> int:
    """A bitrate at which a video of this size looks good, bit/s

    Args:
        width: px
        height: px
        rate: Pictures in a second
        codec: One of `codecs`
    """
def is_hardware(name: str) -> bool:
    """Is it one of the graphics hardware? Those that compute are named after their library

    Args:
        name: An encoder of PyAV
    """

class Codec:
    "An encoder of PyAV that is open; no B pictures, no delay"
    name: str
    format: Any
    wanted: VideoFormat
    key_time: Any
    def __init__(self, name: str, format: VideoFormat) -> None:
        """
        Args:
            name: Its name in PyAV, for example `libx264`
            format: What it shall make; `headers` are known after the first picture
        """
    def encode(self, frame: Any, time: float, key: bool = False) -> list:
        """What is ready after this frame: one access unit; raises `av.FFmpegError` when the encoder fails

        Args:
            frame: With `image`, `number` and `time_utc`
            time: When it came, monotonic s
            key: As a key picture?
        """
works: Any
def encoder_names(codec: str = 'h264', hardware: bool = True) -> Generator[Any, None, None]:
    """The encoders of PyAV that work here; raises `ValueError` when there is none

    Args:
        codec: One of `codecs`
        hardware: Also those of the graphics hardware?
    """
def open_codec(format: VideoFormat, frame: Any, time: float, hardware: bool = True) -> tuple:
    """The best encoder that takes this format; raises `ValueError` or `av.FFmpegError` when there is none

    Args:
        format: What it shall make
        frame: The first frame
        time: When it came, monotonic s
        hardware: Try the graphics hardware first?
    """

__all__ = [
    'even', 'fitted', 'Planes', 'sensible_bitrate', 'is_hardware', 'Codec', 'works', 'encoder_names', 'open_codec',
]
