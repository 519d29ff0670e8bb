"With PARAM_EXT all settings are listed, can be read by name and by number, are set with an answer, and wrong values are refused."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any, NamedTuple


class ParamExt(NamedTuple):
    "What a PARAM_EXT_VALUE or PARAM_EXT_ACK says"
    name: str
    kind: int
    raw: bytes
    index: int = ...  # type: ignore[assignment]
    count: int = ...  # type: ignore[assignment]
    result: int = ...
    @property
    def value(self) -> Any:
        "As a number; `bytes` for custom"
def param_ext(msg: Any) -> ParamExt:
    "What is in a message"
def raw_value(kind: int, value: Any) -> bytes:
    "A number as it is sent"

__all__ = ['ParamExt', 'param_ext', 'raw_value']
