"Find in a log which answer belongs to which command, and read the conversation line by line."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.dialect import Ack
from UAV.wire.message_log import Entry
from dataclasses import dataclass
from typing import Any


class Exchange:
    "A command, its retransmissions, and the acks to it"
    sends: list
    acks: list
    command: Any
    source: Any
    target: Any
    def __init__(self, first: Entry) -> None: ...
    @property
    def ack(self) -> Ack:
        "The latest answer"
    def finals(self, source: tuple | None = None) -> int:
        """How many answers are not IN_PROGRESS

        Args:
            source: Only of this `(system, component)`
        """
    def is_repeated_by(self, e: Entry) -> bool:
        "Is `e` a retransmission of this?"
    def may_have_answer(self, e: Entry) -> bool:
        "Is the ack `e` from the one that was asked, to the one that asked? 0 stands for all"
def pair(entries: Any) -> list:
    """The commands among `entries`, each an `Exchange`

    Args:
        entries: Of a log, in order; those of a command and its acks get their `exchange`
    """
def once(entries: list, window: float = 0.3) -> list:
    """`entries` without frames that came twice

    Args:
        entries: In order
        window: Seconds in which a frame does not come again; some senders never count theirs
    """

@dataclass
class Row:
    "One line of the story: a message, several alike, or an answer that never came"
    entries: list
    source: tuple
    target: tuple
    kind: str
    exchange: Exchange | None = ...
    missing: bool = ...
    @property
    def first(self) -> Entry:
        "The message that it began with"
    @property
    def is_for_all(self) -> bool:
        "Is it for all systems?"
    def takes(self, e: Entry) -> bool:
        "Is `e` one more of the same, for all, so that they can share a row?"
    def words(self, before: Row | None = None) -> str:
        """What stands on the line

        Args:
            before: The row above
        """
    def tip(self, times: bool = False) -> str:
        """What is in its first message, a field a line

        Args:
            times: With times and serial numbers
        """
def rows_of(entries: list) -> list:
    """The story that `entries` tell, each line a `Row`

    Args:
        entries: In order, after `pair`
    """
def told(entries: list, names: tuple = ..., usual: tuple = ...) -> list:
    """Those of `entries` that have one of the names, or are usual, or were asked for

    Args:
        entries: In order
        names: Of messages, as in 'COMMAND_*'
        usual: When there are no `names`
    """

@dataclass
class Lane:
    "A component, from left to right"
    address: tuple
    index: int
    name: str
    below: str
    ours: bool
    silent: bool
    x: int = ...
def reached(row: Row, lanes: dict) -> list:
    "The lanes that the message of `row` is for"
def lanes_of(rows: list, entries: list, heartbeats: dict, counts: bool = True) -> dict:
    """`{(system, component): Lane}` for `rows`, from left to right

    Args:
        rows: A `Row` each
        entries: All that passed, shown or not
        heartbeats: `{(system, component): Entry}`
        counts: Say how many heartbeats came
    """

__all__ = ['Exchange', 'pair', 'once', 'Row', 'rows_of', 'told', 'Lane', 'reached', 'lanes_of']
