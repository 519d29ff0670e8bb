"pymavlink's messages and enums, with what they lack: messages that print themselves, names for numbers, and plain values."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any
from typing_extensions import Self

def address(msg: Any) -> tuple:
    "`(system, component)` that sent `msg`"
def enum_name(enum: str, value: int, prefix: str = '') -> str:
    "The dialect's name for `value` of `enum`, without `prefix`; the number itself when it has none"
def enum_value(enum: str, name: str, prefix: str = '') -> int:
    "The number that the dialect gives to `prefix+name`, in whatever case; raises `KeyError`"
def number_of(enum: str, value: int | str, prefix: str = '') -> int:
    """The number of `value`; raises `ValueError` for a word that `enum` does not have

    Args:
        enum: Its name in the dialect
        value: A number, or a word such as `'range'`
        prefix: What the dialect writes before the word
    """

class Ack(int):
    "1 if a command was accepted, else 0; it remembers by whom and why"
    copies: int
    result: int | None
    source: tuple | None
    command: int | None
    lost: str
    param: int
    target: tuple | None
    heard: str
    def __new__(
            cls, result: int | None, source: tuple | None = None, command: int | None = None, lost: str = '',
            param: int = 0, target: tuple | None = None, heard: str = '',
    ) -> Self:
        """
        Args:
            result: MAV_RESULT; `None`: no answer
            source: `(system, component)` that answered
            command: MAV_CMD that was asked
            lost: Why there was no answer, when that is known
            param: `result_param2` of the COMMAND_ACK: its meaning depends on the command
            target: `(system, component)` that was asked; 0 for all
            heard: Who was heard, when the target never was
        """
    @property
    def reason(self) -> str:
        "What the dialect says about `result`, in one sentence"
    def check(self) -> Ack:
        "Itself when accepted; raises `NoAnswer`, or the `CommandError` for its result"
def message_class(msg_id: int, name: str, crc_extra: int, wire: str, names: list) -> Any:
    "A pymavlink class for a message of numbers: its fields' `names`, and their `struct` types as on the `wire`"
command_cancel: type[Any]
timesync: type[Any]
def parameters(msg: Any) -> list:
    "The seven parameters of a COMMAND_LONG or COMMAND_INT, `None` where not given (NaN, INT32_MAX)"

class MAVError(Exception):
    "Something MAVLink could not do"

class LinkError(MAVError, ConnectionError):
    "A link that cannot be opened, or was closed"

__all__ = [
    'command_cancel', 'timesync', 'address', 'enum_name', 'enum_value', 'number_of', 'Ack', 'message_class',
    'parameters', 'MAVError', 'LinkError',
]
