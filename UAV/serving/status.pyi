"See in one line how a camera is, how many watch it and which stations it hears; in a log, only the news."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Status:
    "What there is to see of a camera that is served"
    streams: tuple = ...
    pictures: int = ...
    recordings: int = ...
    recording: float | None = ...
    free: float = ...
    heard: tuple = ...
    fault: str | None = ...
    gimbal: tuple | None = ...
    def is_news(self, last: Status | None) -> bool:
        """Does it tell more than that a recording goes on, and that a gimbal turns?

        Args:
            last: What was told before
        """
def gimbal_of(com: Any) -> tuple | None:
    """Pitch and yaw of the gimbal that it serves, and its fault or who is in control; `None`: it serves none

    Args:
        com: A `MAVCom`
    """
def status_of(camera: Any, com: Any) -> Status:
    """What there is to see now

    Args:
        camera: A Camera
        com: The `MAVCom` that serves it
    """
def statuses(camera: Any, com: Any, period: float = 1.0) -> Generator[Any, None, None]:
    """The status now, and again and again

    Args:
        camera: A Camera
        com: The `MAVCom` that serves it
        period: s
    """

class Teller:
    "Tells a status: on a terminal over the last one, elsewhere only when it is news"
    over: str
    out: Any
    last: Status | Any
    live: Any
    def __init__(self, out: Any = None) -> None:
        """
        Args:
            out: Where to; `None`: standard output
        """
    def say(self, text: str) -> None:
        "Print a line; on a terminal over the last status"
    def tell(self, status: Status) -> None:
        "Show `status`"
def log_to(teller: Teller) -> None:
    "Have all loggers tell their lines there, above the status"

__all__ = ['Status', 'gimbal_of', 'status_of', 'statuses', 'Teller', 'log_to']
