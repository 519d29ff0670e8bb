"`Keeper` starts a GStreamer pipeline again after each error, so that the camera goes on."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.cameras.gst_pipeline import GSTPipeline
from typing import Any


class Keeper:
    "Keeps a pipeline running, on a thread of its own"
    line: str
    owner: Any
    name: str
    pipeline: GSTPipeline | Any
    problem: str | None | Any
    closing: threading.Event
    thread: threading.Thread | Any
    def __init__(self, line: str, owner: Any, name: str) -> None:
        """
        Args:
            line: The pipeline
            owner: Its `prepare(pipeline)`, `on_problem(text)`, `on_beat()`, `log` and times are used
            name: For people
        """
    def start(self) -> None:
        "Begin; may be called once"
    def close(self, timeout: float) -> bool:
        """End the pipeline and the thread; false when that takes too long. May be called twice

        Args:
            timeout: s
        """

__all__ = ['Keeper']
