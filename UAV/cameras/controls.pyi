"Find out which settings a device has, such as brightness, gain and exposure, and how far each goes."
# Written by .ci/stubs.py from the live classes: do not edit.
import queue
from UAV.cameras.parameter import Parameter
from typing import Any

def takes(capture: Any, number: int, value: float) -> bool:
    """Can the property be set to `value`?

    Args:
        capture: A `cv2.VideoCapture`
        number: `cv2.CAP_PROP_…`
        value: That is tried
    """
def has(capture: Any, number: int) -> bool:
    "Does the device take back what it says?"
def end_of(capture: Any, number: int, towards: int) -> float:
    """The last value that the device takes; leaves it there

    Args:
        capture: A `cv2.VideoCapture`
        number: `cv2.CAP_PROP_…`
        towards: -1: the lower end; 1: the upper
    """
def range_of(capture: Any, number: int) -> tuple | None:
    "Least value, greatest value, and the present one, which stays; `None` when there is nothing to choose"
def switch(capture: Any, name: str) -> Parameter | None:
    """The positions that a switch has; it is left at manual. `None` when the device has none

    Args:
        capture: A `cv2.VideoCapture`
        name: Of a property of the two
    """
def number_of(name: str) -> int:
    "OpenCV's number of a property"
def slider(capture: Any, name: str) -> Parameter | None:
    "A property with a range; `None` when the device has none"
def find_controls(capture: Any) -> list:
    """What the device lets us set, as `Parameter`s; their defaults are the values that it has now, and keeps

    Args:
        capture: A `cv2.VideoCapture`
    """

class Controls:
    "What the reader of a device is to set, and has set"
    declared: list
    defaults: dict
    wishes: queue.SimpleQueue
    made: dict
    def __init__(self, capture: Any = None) -> None:
        """
        Args:
            capture: A `cv2.VideoCapture`; `None` has nothing to be set
        """
    def set(self, name: str, value: float, timeout: float) -> dict:
        """Have the reader set it; raises `CameraError`

        Args:
            name: Of a parameter
            timeout: s that the reader may take
        """
    def serve(self, capture: Any) -> None:
        "The reader calls this between two frames: do what is asked"
    def again(self, capture: Any) -> None:
        "Set a device that came back as the old one was"
    def leave(self, capture: Any) -> None:
        "Leave the device as it was found"

__all__ = ['takes', 'has', 'end_of', 'range_of', 'switch', 'number_of', 'slider', 'find_controls', 'Controls']
