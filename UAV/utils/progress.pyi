"One line that shows how far a download is, on a terminal or in a notebook."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Progress:
    "Shows how far something is: call it with what is done and what there is in all"
    width: int
    every: float
    name: str
    unit: str
    clock: Any
    stream: Any
    handle: Any
    done: int
    total: int
    began: Any
    def __init__(self, name: str = '', stream: Any = None, unit: str = 'B', clock: Any = ...) -> None:
        """
        Args:
            name: What goes on
            stream: A terminal; `None`: the notebook's output, or else `sys.stderr` when that is a terminal
            unit: Of the numbers
            clock: Gives seconds
        """
    @property
    def line(self) -> str:
        "What is shown"
    def __call__(self, done: int, total: int) -> None:
        "So much is done"
def amount(number: float, unit: str = 'B') -> str:
    """A number that people can read: `3.4 kB`

    Args:
        number: Of what
    """

__all__ = ['Progress', 'amount']
