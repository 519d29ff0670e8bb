"`FtpParts` keeps the books of a download: what has come, what is missing, and where the next burst begins."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class FtpParts:
    "What has come of a file"
    reach: int
    size: int
    end: Any
    holes: Any
    fresh: list
    count: int
    def __init__(self, size: int, start: int = 0) -> None:
        """
        Args:
            size: Bytes in all
            start: Bytes that were there before
        """
    def take(self, offset: int, data: bytes) -> bool:
        "Data have come; is there anything new in them?"
    @property
    def done(self) -> int:
        "Bytes that have come"
    @property
    def whole(self) -> bool:
        "Has all come?"
    def wanted(self, most: int = 1000) -> list:
        """`(offset, size)` for each ReadFile that fills a hole, the first ones

        Args:
            most: How many of them
        """
    def take_fresh(self) -> list:
        "What is to be written since we asked last"
    @property
    def prefix(self) -> int:
        "Bytes from the start without a hole: so much is worth keeping when we give up"

__all__ = ['FtpParts']
