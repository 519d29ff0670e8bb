"Follow a target from picture to picture: where it is, how large, how sure that is, and where it comes back when it was lost."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.appearance import Appearance, Colours, Portrait
from typing import Any


class Follower:
    "Follows a target from picture to picture"
    good: float
    learned: float
    again: float
    smallest: float
    middle: Any
    speed: Any
    size: Any
    shape: Appearance
    colours: Colours
    portrait: Portrait
    confidence: Any
    lost: bool
    face: Any
    def __init__(self, image: Any, box: Any) -> None:
        """
        Args:
            image: BGR picture, uint8
            box: The target: left, top, right, bottom, px
        """
    @property
    def box(self) -> tuple:
        "left, top, right, bottom, px"
    def keep(self, image: Any) -> None:
        "Remember what it looks like, for when it is lost"
    def move(self, image: Any) -> None:
        "Go where the target fits best, and take its size from there"
    def blob(self, square: Any) -> Any:
        "The part of a square that has the target's colours: x, y, width, height, px of the square; or `None`"
    def fit(self, image: Any) -> bool:
        "Draw the rectangle towards the pixels that have its colours; are there some?"
    def judge(self, image: Any) -> None:
        "The place is found; is it the target that is there?"
    def learn(self, image: Any, before: Any) -> None:
        "It was at `before` in the last picture, and is here now: how it looks, and how fast it goes"
    def follow(self, image: Any) -> float:
        """Where is it now? `box` says it; returns the confidence, and below `good` it is `lost`

        Args:
            image: The next picture
        """
    def spots(self, image: Any) -> list:
        "The three places of the whole picture where it is most likely: x, y, px"
    def search(self, image: Any) -> None:
        "Look for a lost target in the whole picture; when it is there, go on from there"
    def rescale(self, about: Any, factor: Any) -> None:
        """The pictures are larger from now on, by a zoom or because they have more pixels

        Args:
            about: x, y, px: what stays where it is
            factor: How much larger all becomes; two numbers when width and height differ
        """

__all__ = ['Follower']
