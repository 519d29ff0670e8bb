"For tests: a link between a sound camera and its peers that changes messages, so that an ack is lost, a number wrong, or a notice doubled."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.links import Link
from collections import defaultdict
from typing import Any, TypeVar
_T = TypeVar('_T')


class Meddler(Link):
    "Wraps a link; `outgoing` and `incoming` change the messages that pass"
    datagrams: bool
    link: Any
    outgoing: defaultdict
    incoming: defaultdict
    asked: list
    def __init__(self, link: Link | str) -> None: ...
    def __getattr__(self, name: Any) -> Any: ...
    def close(self) -> None: ...
    def release(self) -> None: ...
    def welcome(self, peer: Any) -> None: ...
    def gone(self, peer: Any) -> bool: ...
    def write(self, data: bytes, peer: Any = None) -> None: ...
    def recv(self) -> Any: ...
def adopted(msg: _T, parent: Any) -> _T:
    "`msg` with the sender of `parent`, when it has none"
def drop(m: Any) -> list:
    "It is lost"
def double(m: Any) -> list:
    "It comes twice"
def put(**fields: Any) -> Any:
    "A function that sets fields: to a value, or to what a function makes of the old one"
def out(name: str, f: Any, when: Any = ...) -> tuple:
    "A break of what the camera says"
def into(name: str, f: Any, when: Any = ...) -> tuple:
    "A break of what it hears"
def broken(link: Link | str, *breaks: Any) -> Meddler:
    "A link with some breaks; a break that is a function gets the `Meddler`, and gives a list of breaks"

__all__ = ['Meddler', 'adopted', 'drop', 'double', 'put', 'out', 'into', 'broken']
