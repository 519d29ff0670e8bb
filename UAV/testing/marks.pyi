"For tests of video: paint a number and a time into each picture, and read them after encoding."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any, TypeVar
_T = TypeVar('_T')

def mark(image: _T, number: int, time_us: int) -> _T:
    """Paint `number` and `time_us` along the upper edge; raises `ValueError` when the picture is too small

    Args:
        image: BGR picture, at least 64 pixels wide; changed in place
        number: Of the picture; its lowest 32 bits are painted
        time_us: When it was painted, µs of any clock; its lowest 48 bits are painted
    """
def read_mark(image: Any) -> tuple | None:
    """`(number, time_us)` as `mark` painted them; `None` when they cannot be read

    Args:
        image: BGR or grey picture
    """

__all__ = ['mark', 'read_mark']
