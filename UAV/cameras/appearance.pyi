"Find a thing again in the next picture, by its shape, its colours, and a portrait."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

side: int
context: float
def cut_out(image: Any, middle: Any, size: Any) -> Any:
    """The target in the middle of its surroundings; what is beyond the picture's edge is like the edge

    Args:
        image: BGR picture, uint8
        middle: Of the target: x, y, px
        size: Its width and height, px
    """
grid: Any
def spectra(patch: Any) -> Any:
    "The spectra of five planes of a square: colours and edges"

class Appearance:
    "A correlation filter: the shape of a target"
    above: Any
    below: Any
    def __init__(self, square: Any) -> None:
        """
        Args:
            square: As `cut_out` makes it
        """
    def learn(self, square: Any, rate: float) -> None:
        "The target looks like this now; `rate` is 0…1, how much that counts"
    def response(self, square: Any) -> Any:
        "`side` x `side` numbers: the hill is where the target is"
def top_of(response: Any) -> tuple:
    """Height of the hill, and how far its top is from the middle: `(x, y)` in parts of the square

    Args:
        response: As from `Appearance.response`
    """
bins: int
def colour_numbers(image: Any) -> Any:
    "The number of the colour of each pixel, below `bins**3`"

class Colours:
    "Which colours are the target's, and which are those around it"
    inner: Any
    outer: Any
    def __init__(self, square: Any) -> None:
        """
        Args:
            square: As `cut_out` makes it
        """
    def learn(self, square: Any, rate: float) -> None:
        "They are like this now; `rate` is 0…1, how much that counts. What is around it changes faster"
    def likelihood(self, image: Any) -> Any:
        "How likely each pixel is the target's, 0…1; a colour that was never seen has a half"
    def contrast(self, likelihood: Any) -> float:
        """How much more the core of a square is the target's than its ring is: 1 clearly, 0 not at all

        Args:
            likelihood: Of a square
        """

class Portrait:
    "The core of a target: what differs there from what is around it"
    core: Any
    def __init__(self, square: Any) -> None:
        """
        Args:
            square: As `cut_out` makes it
        """
    def learn(self, square: Any, rate: float) -> None:
        "It looks like this now; `rate` is 0…1, how much that counts"
    def likeness(self, square: Any) -> float:
        "1: the same, 0: something else"

__all__ = [
    'side', 'context', 'bins', 'cut_out', 'grid', 'spectra', 'Appearance', 'top_of', 'colour_numbers', 'Colours',
    'Portrait',
]
