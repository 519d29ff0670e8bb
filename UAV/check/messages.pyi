"Check that a message comes when it is asked for, that all of them come, or only the one that was meant, and no more."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.check.prober import Prober
from typing import Any

def must_come(p: Prober, name: str, *params: float) -> Any:
    """The message that REQUEST_MESSAGE brings; raises `NotMet`

    Args:
        name: Of a message
        params: Of REQUEST_MESSAGE, after the first one
    """
def all_of(p: Prober, name: str, count: str) -> list:
    "Each message of a name, which says in its field `count` how many there are; raises `Untested`"
def must_tell_one(p: Prober, name: str, field: str, number: int) -> None:
    """Ask for one of several: it must come, and no other; raises `NotMet`

    Args:
        name: Of a message that there are several of
        field: Where it has its number
        number: The one that is wanted
    """
def counted(p: Prober, name: str, seconds: float) -> int:
    "How many messages of a name come in the time after"
def must_end(p: Prober, name: str, seconds: float = 1.0) -> None:
    "At most one more of a name may come in the time after; raises `NotMet`"

__all__ = ['must_come', 'all_of', 'must_tell_one', 'counted', 'must_end']
