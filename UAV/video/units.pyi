"`AccessUnit`, the bytes of one encoded picture, `VideoFormat`, which says what they are, and `Sink`, which takes them."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any
from typing_extensions import Self

codecs: tuple
clock_rate: int

@dataclass(frozen=True)
class VideoFormat:
    "How a video is encoded"
    codec: str = ...
    width: int = ...
    height: int = ...
    rate: float = ...
    bitrate: int = ...
    headers: bytes = ...

@dataclass(frozen=True, repr=False)
class AccessUnit:
    "All bytes of one encoded picture"
    data: bytes
    key: bool
    time: float
    time_utc: float = ...
    number: int = ...
    format: VideoFormat = ...
def nal_units(data: bytes) -> list:
    """The NAL units of a byte stream, without start codes; empty ones are left out

    Args:
        data: A byte stream
    """
def byte_stream(nals: Any) -> bytes:
    """A byte stream of them: each behind a start code

    Args:
        nals: NAL units
    """
def nal_type(nal: bytes, codec: str = 'h264') -> int:
    """Its type: `nal_unit_type` of ITU-T H.264 table 7-1, or of H.265 table 7-1

    Args:
        nal: A NAL unit
        codec: One of `codecs`
    """
def parameter_sets(data: bytes, codec: str = 'h264') -> list:
    """The parameter sets in it: SPS and PPS, for H.265 the VPS before them

    Args:
        data: A byte stream
        codec: One of `codecs`
    """
def is_key(data: bytes, codec: str = 'h264') -> bool:
    """Can decoding begin with this access unit?

    Args:
        data: A byte stream
        codec: One of `codecs`
    """

class Sink:
    "Takes access units, on a thread of its own; a subclass has `send(unit)`, and `end()` if it likes"
    most: int
    name: str
    source: Any
    dropped: Any
    fault: Any
    def __init__(self, name: str = 'sink') -> None:
        """
        Args:
            name: For its thread and its log lines
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def send(self, unit: AccessUnit) -> Any:
        "Send it on; may take its time, and may raise"
    def end(self) -> Any:
        "Called on the sink's thread when the last unit was sent"
    def put(self, unit: AccessUnit) -> None:
        "Take a unit, and return at once"
    def close(self, timeout: float = 5.0) -> bool:
        """Send what waits, and end; false when that takes longer. May be called twice

        Args:
            timeout: s that the units which wait may take
        """

__all__ = [
    'codecs', 'clock_rate', 'VideoFormat', 'AccessUnit', 'nal_units', 'byte_stream', 'nal_type', 'parameter_sets',
    'is_key', 'Sink',
]
