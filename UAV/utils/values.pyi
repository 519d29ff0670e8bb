"`Value`, a frozen dataclass that knows what is unknown: cameras, gimbals and servers speak to each other in such values."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

NAN: float
def known(value: Any) -> bool:
    "Is `value` there, and not NaN?"

class Value:
    "Base of the dataclasses below: shows what is known, and an unknown equals an unknown"
    def __eq__(self, other: Any) -> Any: ...
def inside(what: str, value: float, low: float = ..., high: float = ...) -> float:
    "`value` as a float; raises `ValueError` unless it is finite and lies between `low` and `high`"
def one_of(what: str, value: str, values: Any) -> str:
    "`value`; raises `ValueError` unless it is one of `values`"
def plain(value: Any) -> Any:
    """`value` as JSON can say it

    Args:
        value: A number, text, tuple, list or dict
    """

__all__ = ['NAN', 'known', 'Value', 'inside', 'one_of', 'plain']
