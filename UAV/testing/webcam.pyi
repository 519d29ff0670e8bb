"For tests: a stand-in at the place where OpenCV opens a USB camera."
# Written by .ci/stubs.py from the live classes: do not edit.
import builtins
import threading
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any


class Webcam:
    "A stand-in for `cv2.VideoCapture`: the device that it opens is in its class, and stays there"
    ranges: dict
    clamps: bool
    period: float
    gone: threading.Event
    threads: builtins.set
    values: dict
    def __init__(self, *args: Any) -> None: ...
    @classmethod
    def plug_in(cls) -> None:
        "A new one, out of its box"
    def isOpened(self) -> bool:
        "It is always open"
    def release(self) -> None:
        "Let go of it"
    def read(self) -> tuple:
        "A frame, as bright as the device is set; none when it was pulled off"
    def get(self, number: int) -> float:
        "The value; -1 for what the device does not have"
    def set(self, number: int, value: float) -> bool:
        "Set it: did it work?"
def property_name(number: int) -> str:
    """Its name, without what all have in front; empty when OpenCV does not know it

    Args:
        number: `cv2.CAP_PROP_…`
    """
@contextmanager
def webcam_plugged_in(device: Any = ...) -> Generator[Any, None, None]:
    """For a `with`: `cv2.VideoCapture` opens a new device of this class

    Args:
        device: Or a subclass
    """

__all__ = ['Webcam', 'property_name', 'webcam_plugged_in']
