"`Seen` remembers for a while what has come and what was answered, so that a repeat is noticed."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Seen:
    "What came lately, and what was noted of it"
    window: float
    most: int
    clock: Any
    def __init__(self, window: float, most: int = 64, clock: Any = ...) -> None:
        """
        Args:
            window: Seconds that it is remembered
            most: How many are remembered; the oldest are forgotten first
            clock: Gives seconds
        """
    def __len__(self) -> Any: ...
    def note(self, key: Any, value: Any = True) -> None:
        "Remember `key`, with a `value`"
    def find(self, key: Any, default: Any = None) -> Any:
        "The value of `key`, or `default` when it has not come within the window"
    def forget(self, key: Any) -> None:
        "As if `key` had never come"
    def setdefault(self, key: Any, value: Any) -> Any:
        "What was noted of `key` within the window; else `value`, which is noted"
    def again(self, key: Any) -> bool:
        "Did `key` come within the window? It is noted in any case"

__all__ = ['Seen']
