"`News` gives each viewer the newest status once, and makes it only while a viewer asks."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any


class News:
    "The newest status, and who waits for a newer one; on one event loop"
    period: float
    status: Any
    run: Any
    number: Any
    newest: Any
    def __init__(self, status: Any) -> None:
        """
        Args:
            status: Function that gives it
        """
    @property
    def tag(self) -> str:
        "The name of the newest status"
    def look(self) -> None:
        "Take the status anew, if it is time"
    def wake(self) -> None:
        "Something has come: those who wait go on"
    def changed(self) -> None:
        "The status has changed: it is looked at at once"
    async def wait(self, timeout: float) -> None:
        """Wait until something comes, or until it is time for the next look

        Args:
            timeout: Seconds
        """

@dataclass(frozen=True)
class Update:
    "What is newer than what a viewer has"
    tag: str
    status: dict | None = ...
    pictures: list = ...

__all__ = ['News', 'Update']
