"Take single pictures and series in order: a timetable, a queue of jobs with its thread, and a watch on the device."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.cameras.trigger import Trigger
from collections import deque
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

def next_slot(slot: int, late: float, interval: float) -> int:
    """The next slot that is still to come

    Args:
        slot: The slot of the picture just taken
        late: Seconds since slot 0 was due
        interval: Seconds between slots
    """
def check_sequence(interval: float, count: int, min_interval: float) -> tuple:
    """`interval` and `count`, made possible; raises `ValueError` when they make no sense

    Args:
        interval: Seconds between pictures
        count: How many; 0 until stopped
        min_interval: The shortest interval the camera can do, s
    """

class CaptureJob:
    "One picture, or a sequence"
    interval: float
    count: int
    index: int
    begun: int
    stop: threading.Event
    def __init__(self, interval: float, count: int, index: int) -> None:
        """
        Args:
            interval: Seconds between pictures; 0 for one picture
            count: How many; 0 until stopped
            index: Of the first picture
        """

class CaptureQueue:
    "What a camera is to take, and the thread that takes it, which lives while there is something to do"
    camera: Any
    jobs: deque
    changed: threading.Condition
    thread: threading.Thread | Any
    running: bool
    progress: Any
    next_index: Any
    state: Any
    told: Any
    refusal: tuple | Any
    trigger: Trigger
    def __init__(self, camera: Any) -> None:
        """
        Args:
            camera: Its `storages`, `_take_picture`, `_tell_picture`, `announce` and `capture_status` are used
        """
    def start(self, interval: float, count: int) -> int:
        """Accept a job; raises `CameraBusy`, `StorageError` or `CameraError`

        Args:
            interval: Seconds between pictures; 0 for one picture
            count: How many; 0 until stopped
        """
    def stop(self) -> None:
        "End a sequence after the picture being taken, and pictures by distance; what was accepted is taken"
    def tell_state(self, state: tuple | None = None) -> None:
        "Announce the state, unless it was announced already"
    def wait_idle(self, timeout: float | None = None) -> bool:
        """Wait until nothing is being taken and all is announced; False on timeout

        Args:
            timeout: s; `None` waits as long as it takes
        """
    def close(self, patience: float) -> bool:
        """Accept nothing more and wait for what was accepted; False when the device did not come back

        Args:
            patience: s that a picture may take
        """
    @contextmanager
    def paused(self, why: str) -> Generator[Any, None, None]:
        """Accept nothing for a while; raises `CameraBusy` when something is being taken

        Args:
            why: What an attempt to take a picture is told
        """

class DeviceWatch:
    "Knows what is wrong with a device, and tells when that changes"
    camera: Any
    fault: Any
    closed: bool
    def __init__(self, camera: Any) -> None:
        """
        Args:
            camera: Its `announce` gets a `DeviceStatus` when the device fails or works again, its `log` a line
        """
    def close(self) -> None:
        "Nothing changes any more"
    def set(self, fault: str | None, error: BaseException | None = None) -> None:
        """Note whether the device works, and tell when that is news

        Args:
            fault: What is wrong with the device; `None`: it works
            error: What was raised, when it is a surprise
        """
    @contextmanager
    def reading(self, patience: float) -> Generator[Any, None, None]:
        """Around a read: sets the fault when it raises or takes too long, and clears it when it succeeds

        Args:
            patience: s; longer is a fault
        """

__all__ = ['next_slot', 'check_sequence', 'CaptureJob', 'CaptureQueue', 'DeviceWatch']
