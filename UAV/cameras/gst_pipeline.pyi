"Run a GStreamer pipeline: start it, take its frames and access units, hear what went wrong, and stop it."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.pipelines import Recipe
from typing import Any

def gst() -> Any:
    "GStreamer's module `Gst`; raises `CameraError` when it is not installed"
def in_words(message: str) -> str:
    """What GStreamer says, with the package of an element that is missing, and without passwords

    Args:
        message: GStreamer's
    """
def gives(line: str) -> str:
    """What comes out: 'h264', 'h265', 'jpeg' or 'raw', also when it is not certain; raises `CameraError`

    Args:
        line: A pipeline without an end
    """
def whole_line(recipe: Recipe) -> tuple:
    "The pipeline that GStreamer gets; raises `CameraError`"

class GSTPipeline:
    "A GStreamer pipeline; raises `CameraError` when its line makes no sense"
    Gst: Any
    name: str
    pipeline: Any
    bus: Any
    live: bool
    arrived: Any
    ended: bool
    film: Any
    def __init__(self, line: str, name: str = 'pipeline') -> None:
        """
        Args:
            line: For `gst_parse_launch`
            name: For people
        """
    def element(self, name: str) -> Any:
        "The element of this name, `None` when there is none"
    def start(self) -> None:
        "Open the source, and begin; raises `CameraError`"
    def problem(self, timeout: float) -> str | None:
        """Wait for a message that says that it is over, and tell it; `None` on timeout, and after `wake`

        Args:
            timeout: s
        """
    def wake(self) -> None:
        "End the waiting of `problem`"
    def watch(self, f: Any = None) -> None:
        """Note in `arrived` when the source gives something, and in `ended` when it is at its end

        Args:
            f: Called with each buffer of the source
        """
    def stop(self, timeout: float = 3.0) -> bool:
        """End it; false when it does not come to an end in time, and goes without us

        Args:
            timeout: s
        """
    def on_sample(self, name: str, f: Any) -> None:
        """Call `f` with each buffer that comes to an appsink

        Args:
            name: Of an appsink
            f: Called as `f(data, width, height, rate, taken)`; `taken` in monotonic s
        """
    def open_valve(self, name: str, on: bool = True, at_key: bool = False) -> None:
        """Open a branch, or close it

        Args:
            name: Of a valve
            on: Open, or closed?
            at_key: Only with the next key picture?
        """
    def ask_key(self, name: str = 'uav_units') -> None:
        "Ask for a key picture at an appsink; an encoder makes one, a camera may"
    def encoder(self) -> tuple:
        "The element with a bitrate, and its unit in bit/s; `(None, 1)` when there is none"
    @property
    def bitrate(self) -> int:
        "What the encoder is set to, bit/s; 0 when there is none, or it does not tell"
    @bitrate.setter
    def bitrate(self, value: Any) -> None: ...
def as_image(data: bytes, width: int, height: int) -> Any:
    """The array height x width x 3 of a frame

    Args:
        data: BGR
        width: px
        height: px
    """

__all__ = ['gst', 'in_words', 'gives', 'whole_line', 'GSTPipeline', 'as_image']
