"Open a UDP link or one inside this process; and what a link of your own must have."
# Written by .ci/stubs.py from the live classes: do not edit.
import socket
from collections.abc import Sequence
from logging import Logger
from typing import Any
from typing_extensions import Self

log: Logger

class Link:
    "Moves bytes; the base of all links. `with` closes it and gives it back"
    prefixes: Sequence
    datagrams: bool
    def recv(self) -> Any:
        "Wait for bytes, however long: `(data, peer)`; `None` only when the link is closed, or has gone"
    def write(self, data: bytes, peer: Any = None) -> Any:
        "Send `data` to `peer`, or to all; what cannot be sent is dropped, as on any radio"
    def close(self) -> Any:
        "Wake a waiting `recv`, and open no more"
    def release(self) -> Any:
        "Give the device back to the system, when no `recv` is under way any more"
    def reopen(self) -> Any:
        "Open it again after it has gone; raises `LinkError` when that cannot be done (yet)"
    def welcome(self, peer: Any) -> Any:
        "Good frames come from `peer`: it gets what is for all"
    def gone(self, peer: Any) -> bool:
        "Has `peer` closed its connection, as far as we can tell?"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...

class VirtualLink(Link):
    "Joins all in this process that open the same name"
    prefixes: Sequence
    datagrams: bool
    name: str
    def __init__(self, name: str, baudrate: int = 0) -> None: ...
    def recv(self) -> Any: ...
    def write(self, data: Any, peer: Any = None) -> None: ...
    def close(self) -> None: ...
def net_address(name: str) -> tuple:
    "`(host, port)` of `HOST:PORT`; raises `LinkError`"

class UDPLink(Link):
    "A UDP socket with its peers; the base of `udpin` and `udpout`"
    datagrams: bool
    sock: socket.socket
    def __init__(self, bind: tuple) -> None: ...
    @property
    def port(self) -> int:
        "Our own port"
    def recv(self) -> Any: ...
    def close(self) -> None: ...
    def pause(self) -> None:
        "Wake a waiting `recv`, which returns `None`; an event loop reads the socket from now on"
    def release(self) -> None: ...
    def reopen(self) -> Any:
        "Bind the same port once more; raises `LinkError` when it is taken, or after `close`"

class UDPOut(UDPLink):
    "`udpout:HOST:PORT`: talks to one address"
    prefixes: Sequence
    peer: tuple
    def __init__(self, name: str, baudrate: int = 0) -> None: ...
    def write(self, data: Any, peer: Any = None) -> None: ...

class UDPIn(UDPLink):
    "`udpin:HOST:PORT`: answers all peers that were welcome in the last `forget` seconds, and the latest in any case"
    prefixes: Sequence
    forget: float
    most: int
    peers: dict
    def __init__(self, name: str, baudrate: int = 0) -> None: ...
    def welcome(self, peer: Any) -> None: ...
    def write(self, data: bytes, peer: Any = None) -> Any: ...
def in_our_words(name: str) -> str:
    """What to write in place of it; empty when it is not written as MAVSDK does

    Args:
        name: A connection string, perhaps of MAVSDK
    """
link_types: list
def kind_meant(name: str) -> str:
    """`name` with the kind of link that was perhaps meant; empty when there is none

    Args:
        name: A connection string of no known kind
    """
def check_name(name: Any) -> None:
    "Raise `LinkError` with what to write, when a connection string is not written as ours are"
def open_link(connection_string: str, baudrate: int = 57600) -> Link:
    """Open the link that `connection_string` names; raises `LinkError` at once when that cannot be done

    Args:
        connection_string: See the table at the top
        baudrate: For serial ports
    """

__all__ = [
    'log', 'link_types', 'Link', 'VirtualLink', 'net_address', 'UDPLink', 'UDPOut', 'UDPIn', 'in_our_words',
    'kind_meant', 'check_name', 'open_link',
]
