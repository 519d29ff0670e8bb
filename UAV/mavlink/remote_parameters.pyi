"One table of a camera's settings on the ground, in words, which follows the camera."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.protocol import Answer
from UAV.wire.dialect import Ack
from collections import deque
from collections.abc import Mapping
from typing import Any
from typing_extensions import Self


class RemoteParameters(Mapping):
    "The settings of one camera: `{name: value}` in the camera's order, always as they were heard last"
    most: int
    target: tuple
    declared: dict
    definition: tuple
    count: Any
    def __init__(self, target: tuple = ...) -> None:
        """
        Args:
            target: `(system, component)` of the camera
        """
    def __len__(self) -> Any: ...
    def __iter__(self) -> Any: ...
    def __contains__(self, name: Any) -> bool: ...
    def __getitem__(self, name: Any) -> Any: ...
    def note(self, msg: Any) -> None:
        "Take a PARAM_EXT_VALUE, or a PARAM_EXT_ACK"
    def keep(self, names: Any) -> None:
        """Forget the others

        Args:
            names: Of all the parameters that there are
        """
    def kind(self, name: str) -> str | None:
        "The type of one, as it was heard or is declared; `None`: it is not known"
    def text(self, name: str) -> str:
        "The value of one in words, with its unit"
    async def until(self, test: Any, timeout: float | None = None) -> bool:
        """Wait until `test` is true; false when that does not happen in time

        Args:
            test: A function of these parameters, such as `lambda p: p['CAM_EV']>0`
            timeout: Seconds; `None` waits as long as it takes
        """

class ParameterAck(Ack):
    "1 if a parameter was set, else 0; it remembers by whom, and what the parameter is now"
    name: str
    now: str
    param_result: int | None
    def __new__(
            cls, result: int | None, name: str, now: str = '', source: tuple | None = None, lost: str = '',
            target: tuple | None = None,
    ) -> Self:
        """
        Args:
            result: PARAM_ACK; `None`: no answer
            name: Of the parameter
            now: What it is now, in words
            source: `(system, component)` that answered
            lost: Why there was no answer, when that is known
            target: `(system, component)` that was asked
        """

class Listing:
    "The answers to a LIST, as they come in"
    count: Any
    indexes: set
    names: set
    def __init__(self) -> None: ...
    def add(self, msg: Any) -> bool:
        "Take a PARAM_EXT_VALUE; is it complete now?"
    def missing(self, most: int = 4) -> list:
        "Some indexes that have not come"

class SetRequest:
    "One SET under way, and the acks that may be its answer"
    name: str
    kind: str
    raw: bytes
    acks: deque
    news: Answer
    def __init__(self, name: str, kind: str, raw: bytes) -> None: ...
    def encode(self, mav: Any, target: tuple) -> Any:
        "The PARAM_EXT_SET"
    def note(self, msg: Any) -> None:
        "Take a PARAM_EXT_ACK, on the reader of the link"
    def is_ours(self, msg: Any) -> bool:
        "Is this our answer for sure?"
    async def next(self, timeout: float) -> Any:
        "The next ack, or `None`"

__all__ = ['RemoteParameters', 'ParameterAck', 'Listing', 'SetRequest']
