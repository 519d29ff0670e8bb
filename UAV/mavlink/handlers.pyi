"Mark a method as the handler of a command: it is called with named arguments, and once for a command that comes twice."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any, NamedTuple

def wanted_parameters(params: dict) -> list:
    "`(name, default, is it whole)` of the positional parameters in `params` (from `inspect.signature`)"
def arguments(wanted: list, values: list) -> dict:
    "Arguments for a handler: one for each of its `wanted_parameters`; raises `Denied`"
def marks_made() -> int:
    "How many marks were made so far: when it grows, tables of them are out of date"
def command(cmd: int, once: bool = False, slow: bool = False, **options: Any) -> Any:
    """Mark a method as the handler of `cmd`: what it returns or raises becomes the ack

    Args:
        cmd: A MAV_CMD
        once: Not to be done again for a retransmission, which gets the old answer
        slow: Waits for a device: run on the component's worker, with IN_PROGRESS acks meanwhile
        options: What a component wants to know besides; it finds them in the handler's `options`
    """
def message(msg_id: int, **options: Any) -> Any:
    """Mark a method as the answer to a request for `msg_id`: it returns the encoded message, or a list of them

    Args:
        msg_id: MAVLINK_MSG_ID
        options: What a component wants to know besides
    """
def receives(msg_id: int, **options: Any) -> Any:
    """Mark a method to be called with each message `msg_id` that arrives for the component

    Args:
        msg_id: MAVLINK_MSG_ID
        options: What a component wants to know besides
    """

class Handler:
    "A marked method, callable with parameters off the wire"
    f: Any
    options: dict
    name: Any
    params: Any
    wants_msg: bool
    wanted: list
    def __init__(self, f: Any, **options: Any) -> None:
        """
        Args:
            f: The bound method
            options: Those of its mark
        """
    def __call__(self, values: list, msg: Any = None) -> Any: ...
def marked(obj: Any, kind: str) -> dict:
    "`{value: Handler}` for all methods of `obj` with a mark of this `kind`; a subclass wins over its base"

class Tables:
    "The marked methods of a component, by kind and number; and the messages that its link must build for it"
    component: Any
    wanted: Any
    def __init__(self, component: Any) -> None: ...
    def __getitem__(self, kind: str) -> dict:
        "`{number: Handler}` of the methods marked as 'command', 'message' or 'receives'"
    def find(self, kind: str) -> dict:
        "`{number: method}` of one kind of marks"
    def join(self, wanted: Any, *more: Any) -> None:
        "Have a link's `Wanted` build the messages that our methods receive, and `more` ids"
    def want(self, *msg_ids: Any) -> None:
        "Have messages with these ids built, until `leave`; `None` means all"
    def leave(self) -> None:
        "Want nothing any more; safe to call twice"

class Outcome(NamedTuple):
    "What a command was answered: its MAV_RESULT, and the `result_param2` of its COMMAND_ACK"
    result: int
    value: int = ...

class Served:
    "What was answered to each sender, lately"
    echo: float
    overtaken: float
    most: int
    most_senders: int
    most_frames: int
    most_alike: int
    clock: Any
    def __init__(self, clock: Any = ...) -> None:
        """
        Args:
            clock: Gives seconds
        """
    def note(self, msg: Any, outcome: Outcome) -> None:
        "Remember what the command `msg` was answered"
    def find(self, msg: Any) -> Outcome | None:
        "What the command `msg` was answered when it came before; `None`: it is new"
    def find_number(self, msg: Any, number: int) -> Outcome | None:
        "What the shot with this `number` was answered; `None`: it is new, has no number (0), or `msg` is a broadcast"
    def note_number(self, msg: Any, number: int, outcome: Outcome) -> Any:
        "Remember what the shot with this `number` was answered; without one (0) its sender has begun to count anew"
    def doubled(self, msg: Any) -> bool:
        "Did this very frame come a moment ago?"

@dataclass(frozen=True)
class Copy:
    "The latest copy of a command that was served"
    outcome: Outcome
    confirmation: int
    seq: int
    when: float

__all__ = [
    'wanted_parameters', 'arguments', 'marks_made', 'command', 'message', 'receives', 'Handler', 'marked', 'Tables',
    'Outcome', 'Served', 'Copy',
]
