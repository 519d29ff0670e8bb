"Open the links of one system, give each component the messages that are for it, and close everything at the end of a `with`."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
import threading
from UAV.mavlink.heart import Heart
from UAV.utils.general import (
    date_time_str as date_time_str, time_UTC_usec as time_UTC_usec, time_since_boot_ms as time_since_boot_ms,
)
from UAV.wire.links import Link
from UAV.wire.reader import Sources, Wanted
from UAV.wire.signing import Signing
from typing import Any, TypeVar
from typing_extensions import Self
_T = TypeVar('_T')

def link_name(link: str | Link) -> str:
    "What to call a link"

class Channel:
    "A link of a `MAVCom`: the thread that reads it, who was heard there, and its way back when it has gone"
    first_retry: float
    last_retry: float
    patience: float
    most_peers: int
    most_strangers: int
    com: Any
    link: Link
    name: str
    number: int
    up: bool
    readers: dict
    sources: Sources
    busy_since: Any
    thread: threading.Thread
    def __init__(self, com: Any, link: Link, name: str, number: int) -> None: ...
    def take(self, data: bytes, peer: Any = None) -> None:
        "Bytes came from `peer`"
    def close(self) -> None:
        "Let go of the link, and wait for the thread"
    def release(self) -> None:
        "Give the link back to the system"
    def write(self, frame: bytes, peer: Any = None) -> None:
        "Send `frame` to one peer of the link, or to all"
    def read_in_loop(self, loop: Any) -> None:
        "Have `loop` read the link, and not a thread; raises `LinkError` when that is no UDP link"
    def take_all(self, most: int = 64) -> None:
        """Take what has come

        Args:
            most: Datagrams at a time
        """
    def leave_loop(self, loop: Any) -> Any:
        "Have `loop` forget the link, then give it back to the system"

class MAVCom:
    "One MAVLink system on one link or several; close it, or use it in a `with`"
    beat_period: float
    lost_after: float
    stuck_after: float
    close_all: Any
    source_system: int
    connection_string: str
    log: logging.Logger
    message_log: Any
    forward: bool
    signing: Any
    component: dict
    channels: list
    wanted: Wanted
    heart: Heart
    def __init__(
            self, connection_string: str | Link, baudrate: int = 57600, source_system: int = 111, loglevel: int = ...,
            signing: Any = None, message_log: Any = None, forward: bool = False,
    ) -> None:
        """
        Args:
            connection_string: pymavlink's: `udpin:HOST:PORT`, `/dev/ttyACM0` …, or `virtual:NAME`; or a `Link`
            baudrate: For serial ports
            source_system: Our system id; a camera on a vehicle has the vehicle's
            signing: Key for signed frames: 32 bytes, a passphrase, the `Path` of a file with one, or a `Signing`
            message_log: A `MessageLog`, or any object with its `add`
            forward: Pass on what is for others, from one link to another
        """
    def add_link(self, connection_string: str | Link, baudrate: int = 57600) -> Channel:
        """Open one more link, and read it; raises `LinkError` when that cannot be done

        Args:
            connection_string: As for the constructor
            baudrate: For serial ports
        """
    @property
    def link(self) -> Link:
        "Our first link"
    def add_component(self, component: _T) -> _T:
        "Add `component`, which beats at once; returns it. Raises `ValueError` when its address is taken, `TypeError`"
    def remove_component(self, component: Any) -> None:
        "`component` is no longer ours; its `close` does this"
    def route(self, msg: Any, origin: Any = None) -> Any:
        """Give `msg` to all components that it is for, except the one that sent it

        Args:
            msg: A message that was read, or one of ours
            origin: Our component that sent it
        """
    def close(self) -> None:
        "Close the components, the links and their threads; safe to call twice"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def remotes(self) -> dict:
        "`{(system, component): Remote}` of all that were heard"
    def name_of(self, source: tuple) -> str:
        "`system/component` and what it is"
    def lost(self, source: tuple) -> str:
        "Why a component that was heard before is lost; empty when it is not"
    def where(self, system: int, component: int) -> list:
        "`(channel, peer)` by which a component was heard lately; failing that, its system"
    def reaches(self, system: int, component: int) -> bool:
        "Is a way to a component open, as far as links can tell? One that was never heard may be anywhere"
    def write(self, frame: bytes, to: tuple | None = None) -> None:
        """Send a frame where it belongs, signed if we sign

        Args:
            frame: A packed message of ours
            to: `(system, component)` that it goes to; `None`: as the message says
        """
    def keep(self, frame: bytes, sent: bool) -> None:
        "Give `frame` to the log; a log that raises is heard of once, and used no more"
    def share(self, frame: bytes, msg_id: int, origin: Any) -> None:
        """Give `frame` to our other components

        Args:
            frame: A packed message
            msg_id: Its id
            origin: The component that sent it
        """
    @property
    def message_cnts(self) -> dict:
        "`{system: {MESSAGE_NAME: count}}` of all frames received"
    @property
    def round_trips(self) -> dict:
        "Seconds to `(system, component)` and back, smoothed, of those that have answered"
    @property
    def link_quality(self) -> list:
        "A `LinkQuality` for each component and link, ordered by address"
    def who_was_heard(self, system: int = 0) -> str:
        """Who was heard, at most eight; when none was, what to ask

        Args:
            system: Only this system, when any of it was heard; 0: all
        """
    def summary(self) -> str:
        "Who was heard, how well, and what our components did, as text"
    async def __aenter__(self) -> Self: ...
    async def __aexit__(self, *args: Any) -> None: ...

__all__ = ['link_name', 'Channel', 'MAVCom', 'date_time_str', 'time_since_boot_ms', 'time_UTC_usec']
