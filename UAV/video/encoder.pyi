"`Encoder` turns the newest frame of a camera into access units, once for all viewers and recordings."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.units import VideoFormat
from typing import Any
from typing_extensions import Self


class Pace:
    "At most so many pictures a second on average, and none of them delayed"
    last: Any
    def __init__(self, now: float, rate: float) -> None: ...
    def wait(self, now: float, rate: float) -> float:
        "How long a frame that comes now is too early, s; a quarter of the interval is not minded"
    def took(self, now: float, rate: float) -> None:
        "A frame that came now was taken"

class Measured:
    "What an encoder really produced in the last two seconds"
    span: float
    def __init__(self) -> None: ...
    def add(self, time: float, size: int) -> None:
        "An access unit of `size` bytes came out at `time`, monotonic s"
    @property
    def rate(self) -> float:
        "Pictures in a second"
    @property
    def bitrate(self) -> float:
        "bit/s"

class _Setting:
    "An attribute that may be set while the encoder runs; it counts from the next picture on"
    check: Any
    name: Any
    def __init__(self, check: Any) -> None: ...

class Encoder:
    "Encodes the newest frame of a source once, for all its sinks; `with` closes it"
    silence: float
    pause: float
    patience: float
    size: Any
    bitrate: Any
    rate: Any
    key_interval: Any
    format: Any
    fault: Any
    measured: Measured
    source: Any
    codec: str
    name: str
    hardware: bool
    def __init__(
            self, source: Any, codec: str = 'h264', size: tuple | None = None, rate: float = 15.0,
            bitrate: int | None = None, key_interval: float = 1.0, name: str = 'video', hardware: bool = True,
    ) -> None:
        """
        Args:
            source: Of frames: `watching()` and `next(after, timeout)`
            codec: One of `codecs`
            size: (width, height), px, made even; `None`: as the frames are
            rate: Pictures in a second, at most
            bitrate: bit/s; `None`: one that suits size and rate
            key_interval: s between two key pictures, at most
            name: For its thread and its log lines
            hardware: Use the graphics hardware where it works?
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def sinks(self) -> tuple:
        "All that get the units"
    def key_frame(self) -> None:
        "Make the next picture a key picture"
    def add(self, sink: Any) -> None:
        """Give it all units from the next key picture on; raises `RuntimeError` when closed

        Args:
            sink: With `put(unit)`, which is called on our thread and must return at once
        """
    def remove(self, sink: Any, wait: bool = True) -> None:
        """Give it nothing any more

        Args:
            sink: One of `sinks`; others are ignored
            wait: Until its last unit is delivered, and until the thread has ended when it was the last sink?
        """
    def close(self) -> None:
        "Let all sinks go, and end the thread; may be called twice"
    def wait_format(self, timeout: float = 5.0) -> VideoFormat | None:
        """The format with its `headers`; starts the source for a moment when it must; `None` after the timeout

        Args:
            timeout: s
        """

class _Glance:
    "A sink that only wants the encoder to run"
    def put(self, unit: Any) -> Any: ...

__all__ = ['Pace', 'Measured', 'Encoder']
