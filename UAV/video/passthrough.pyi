"Stream and record the H.264 that a camera gives, without encoding it a second time."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.encoder import Encoder
from typing import Any

def with_sets(data: bytes, sets: Any, codec: str = 'h264') -> bytes:
    """The key picture, with the parameter sets before it

    Args:
        data: A key picture, as a byte stream
        sets: The parameter sets, as NAL units
        codec: One of `codecs`
    """

class _Decided:
    "An attribute that the source decides on: what the format says of it"
    of: Any
    unknown: Any
    name: Any
    def __init__(self, of: Any, unknown: Any = None) -> None:
        """
        Args:
            of: Takes it from a `VideoFormat`
            unknown: Its value as long as no format is known
        """

class _Bitrate(_Decided): ...

class PassThrough(Encoder):
    "Hands the access units of a source that encodes by itself to any number of sinks"
    size: Any
    bitrate: Any
    rate: Any
    key_interval: Any
    complete: bool
    expected: Any
    def __init__(self, codec: str = 'h264', name: str = 'video') -> None:
        """
        Args:
            codec: One of `codecs`
            name: For people
        """
    def run(self, on: bool) -> Any:
        "Called with true before the first unit is wanted, and with false after the last"
    def ask_key(self) -> Any:
        "Called when a key picture is wanted soon"
    def set_bitrate(self, bitrate: int) -> Any:
        """Have the source use it; raises `ValueError` when it cannot

        Args:
            bitrate: bit/s
        """
    def key_frame(self) -> None:
        "Ask for a key picture soon; a source that cannot do that sends one when it likes"
    def add(self, sink: Any) -> None:
        "Give it all units from the next key picture on; raises `RuntimeError` when closed"
    def push(self, data: bytes, taken: float | None = None, **known: Any) -> None:
        """Hand an access unit to all sinks; nothing happens before the first key picture

        Args:
            data: An access unit, as a byte stream
            taken: When the frame was taken, monotonic s; `None` is now
            known: What is known of the format: `width`, `height`, `rate`, `bitrate`
        """

__all__ = ['with_sets', 'PassThrough']
