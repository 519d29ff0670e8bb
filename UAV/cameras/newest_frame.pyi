"`NewestFrame` hands the newest frame from the thread that reads a source to all who wait for one."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.cameras.values import Frame
from typing import Any


class NewestFrame:
    "The newest frame of a source, for all who wait for a later one"
    frame: Frame | Any
    number: int
    arrived: Any
    taken: bool
    problem: str | Any
    fresh: threading.Condition
    def __init__(self) -> None: ...
    def put(self, image: Any) -> None:
        "Replace the newest frame"
    def end(self, problem: str) -> None:
        """No frame will come any more

        Args:
            problem: Why
        """
    def next(self, after: int, timeout: float, untaken: bool = False) -> Frame | None:
        """A frame later than `after`; `None` when none comes. Raises `CameraError` after `end`

        Args:
            after: The number of the last frame seen
            timeout: s
            untaken: Only one that no one has got yet?
        """
    def wait_taken(self) -> None:
        "Wait until the newest frame was read, or there is a problem"

__all__ = ['NewestFrame']
