"Keep each frame that comes on a link with its time, and ask later what came, when, and in which order."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.links import Link
from typing import Any, NamedTuple


class Heard(NamedTuple):
    "A message, and when it came"
    msg: Any
    at: float
    @property
    def name(self) -> str:
        "Such as 'HEARTBEAT'"
    @property
    def source(self) -> tuple:
        "`(system, component)` that sent it"

class Recorder:
    "All that comes in on a link, but no flood"
    most: int
    most_a_second: int
    link: Link
    heard: list
    ended: bool
    flooded: int
    def __init__(self, link: Link) -> None:
        """
        Args:
            link: Ours alone; `close` closes it
        """
    def __len__(self) -> Any: ...
    def close(self) -> None:
        "Close the link, and end the thread"
    def wait(self, fits: Any, timeout: float, since: int = 0) -> Heard | None:
        """The first one that fits; `None` when none comes in time. Raises `LinkError` when the link has gone

        Args:
            fits: Called with each `Heard`: is it the one?
            timeout: s
            since: Where in the record to begin
        """

__all__ = ['Heard', 'Recorder']
