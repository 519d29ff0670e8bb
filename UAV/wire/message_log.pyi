"`MessageLog` keeps the messages that pass a link: list them, filter them, write them to a file and read them again."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.chart import Chart
from collections.abc import Sequence
from functools import cached_property
from typing import Any
from typing_extensions import Self


class Entry:
    "One frame that passed"
    time: float
    sent: bool | None
    frame: bytes
    exchange: Any
    msg_id: Any
    source: tuple
    def __init__(self, time: float, sent: bool | None, frame: bytes) -> None:
        """
        Args:
            time: Seconds since 1970
            sent: By us; `None`: not known
            frame: Whole; its signature is left out
        """
    @property
    def name(self) -> str:
        "Of the message"
    @property
    def target(self) -> tuple:
        "`(system, component)` it is for; 0 is all"
    @cached_property
    def message(self) -> Any:
        "The pymavlink message, or `None` when the dialect does not know its id"
    @property
    def is_command(self) -> bool:
        "COMMAND_LONG or COMMAND_INT"
    @property
    def is_ack(self) -> bool:
        "COMMAND_ACK"
    @property
    def is_retransmission(self) -> bool:
        "A COMMAND_LONG with a `confirmation`"
    @property
    def command_name(self) -> str:
        "Of the MAV_CMD that this asks for, or answers"
    @property
    def detail(self) -> str:
        "The field that tells one message of this type from the next"
    @property
    def says(self) -> str:
        "The message in a few words"
    def fields(self, times: bool = True) -> list:
        """`name: value` of each field; nothing for a message that the dialect does not know

        Args:
            times: With times and serial numbers, which are other ones on each run
        """
def message_name(msg_id: Any) -> str:
    "The dialect's name for a message id"
def one_line(text: Any, most: int = 60) -> str:
    "`text` in one line of printable characters, at most `most` of them"
def address_text(address: tuple) -> str:
    "`1/100`, or `1/all` for `(1,0)`"
def component_name(address: tuple, heartbeat: Entry | None = None) -> str:
    """What it is: the type in its heartbeat, or else what MAVLink reserves its number for

    Args:
        address: `(system, component)`
        heartbeat: Of it
    """

class MessageLog:
    "Keeps the frames that pass; one with a `file` writes them there too, and is to be closed, or used in a `with`"
    usual: Sequence
    load: Any
    total: int
    def __init__(self, file: Any = None, most: int | None = 100000) -> None:
        """
        Args:
            file: A `.tlog` to write as it goes; what is in it stays
            most: Frames to keep in memory; `None`: all
        """
    def add(self, frame: bytes, sent: bool | None = None, when: float | None = None) -> None:
        """Keep `frame`; quick, and from any thread

        Args:
            frame: A whole frame, its CRC checked
            sent: By us
            when: Seconds since 1970; `None` is now
        """
    def close(self) -> None:
        "Finish the file; the frames in memory stay"
    def clear(self) -> None:
        "Forget what is in memory, but not what the components are"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def __len__(self) -> Any: ...
    def entries(self, *names: str) -> list:
        """What passed, each an `Entry`, oldest first

        Args:
            names: Of messages, as in 'COMMAND_ACK' or 'CAMERA_*'; none: all
        """
    def __iter__(self) -> Any: ...
    def messages(self, *names: str) -> list:
        "The messages that passed, oldest first"
    def heartbeats(self) -> dict:
        "`{(system, component): Entry}`, the latest HEARTBEAT of each"
    def text(self, *names: str, rows: int = 60) -> str:
        """What passed, one message a line

        Args:
            names: What to list; none: the `usual` ones
            rows: The newest
        """
    def save(self, file: Any) -> None:
        """Write what is in memory

        Args:
            file: A `.tlog`; what was in it is lost
        """
    def exchanges(self) -> list:
        "The commands that passed, each an `Exchange` with its answers"
    def chart(self, *names: str, rows: int = 60, times: bool = False, counts: bool = True) -> Chart:
        """A picture of who said what to whom; raises `ValueError` for a name that the dialect does not have

        Args:
            names: Messages to draw, as in 'COMMAND_*'; none: the `usual` ones, and what was asked for by REQUEST_MESSAGE
            rows: Draw the newest
            times: Draw a ruler of seconds as well
            counts: Say how many heartbeats and other messages were left out
        """
message_ids: Any

__all__ = ['Entry', 'message_name', 'one_line', 'address_text', 'component_name', 'MessageLog', 'message_ids']
