"Put a boolean, a number or any 128 bytes into a PARAM_EXT message, and get it back whole."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

PARAM_EXT_ACK: int
PARAM_EXT_REQUEST_LIST: int
PARAM_EXT_REQUEST_READ: int
PARAM_EXT_SET: int
PARAM_EXT_VALUE: int
def param_type(kind: str) -> int:
    """MAV_PARAM_EXT_TYPE of a parameter of this kind

    Args:
        kind: One of `kinds`, such as 'uint8'
    """
def pack_value(kind: str, value: Any) -> bytes:
    """`value` as the wire has it: 128 bytes

    Args:
        kind: One of `kinds`
        value: In this type
    """
def kind_of(number: int) -> str | None:
    """The kind of a parameter with this type on the wire; `None`: there is none

    Args:
        number: A MAV_PARAM_EXT_TYPE
    """
def unpack_value(kind: str | None, raw: bytes) -> Any:
    """The number or the bytes in `raw`; `None` when the type is not known

    Args:
        kind: As `kind_of` gives it
        raw: What is left of the 128 bytes
    """
def param_name(msg: Any) -> str:
    """The name of the parameter: 16 bytes at most, with or without a 0 at the end

    Args:
        msg: Any of the PARAM_EXT messages with a name
    """
def param_value(msg: Any) -> Any:
    """The value in it; `None` when its type is not known

    Args:
        msg: A PARAM_EXT_VALUE, PARAM_EXT_SET or PARAM_EXT_ACK
    """

__all__ = [
    'param_type', 'pack_value', 'kind_of', 'unpack_value', 'param_name', 'param_value', 'PARAM_EXT_ACK',
    'PARAM_EXT_REQUEST_LIST', 'PARAM_EXT_REQUEST_READ', 'PARAM_EXT_SET', 'PARAM_EXT_VALUE',
]
