"`PictureLog` knows which pictures you want, which notices of them have come, and which are missing."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from typing import Any


class PictureLog:
    "Which pictures of a camera are wanted, in order, and which of their notices have come"
    most: int
    sure: int
    runs: Any
    unknown: Any
    notices: dict
    skipped: set
    came: Any
    last: Any
    since: int
    odd: Any
    def __init__(self, first: int | None = None, count: float = ..., since: int = 0) -> None:
        """
        Args:
            first: Index of the first one wanted; `None`: of the first one that comes
            count: How many are wanted; 0: none before `begin`
            since: The camera's time since boot when its count was `first`, ms
        """
    def begin(self, first: int | None, count: float = 1) -> None:
        "Want `count` more pictures, from index `first` on"
    @property
    def left(self) -> float:
        "How many are wanted, and not given yet"
    @property
    def endless(self) -> bool:
        "Is there no last one?"
    def wanted(self) -> Generator[Any, None, None]:
        "The wanted indexes that are known, in order, one by one"
    def ready(self, most: float = ...) -> list:
        "The notices that can be given now, in order and without a gap"
    def add(self, msg: Any) -> None:
        "Keep a CAMERA_IMAGE_CAPTURED"
    def take(self, most: float = ...) -> list:
        "Hand out what is `ready`"
    def skip(self, index: int, msg: Any = None) -> None:
        "Picture `index` is given already (`msg`), or cannot be had"
    def missing(self, image_count: int, most: int = 16) -> list:
        """Wanted pictures that were taken, and whose notices have not come

        Args:
            image_count: Of CAMERA_CAPTURE_STATUS
            most: Name no more than so many at a time
        """
    def judge(self, image_count: int, idle: bool, seen: Any) -> str:
        """What is odd about the camera's count, when enough looks agree; else empty

        Args:
            image_count: Of CAMERA_CAPTURE_STATUS
            idle: Says the camera that it takes no pictures?
            seen: Indexes of the notices that had come when it was asked
        """
    def cut(self, image_count: int) -> float:
        "Want no picture that was not taken; how many these were"
    def adopt(self) -> None:
        "The notices that have come are the wanted ones, by any index"
    def guess(self, first: int) -> None:
        "Begin at `first` when no notice has told where"
    def instead(self, index: int) -> None:
        "The wanted one is `index`"

__all__ = ['PictureLog']
