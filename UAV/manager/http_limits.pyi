"Decide which browsers the panel answers, how long a request may take, and how large it may be."
# Written by .ci/stubs.py from the live classes: do not edit.
import io
from dataclasses import dataclass
from typing import Any


class Refused(Exception):
    "A request that is refused: a status of HTTP, and a sentence"
    status: int
    text: Any
    def __init__(self, status: int, text: str = '') -> None:
        """
        Args:
            status: Such as 403
            text: For people; empty: what HTTP says
        """
    @property
    def reply(self) -> Reply:
        "The answer that tells it"
def name_of(place: str) -> str:
    """Name or address without the port, in small letters; empty when it is neither

    Args:
        place: As in a `Host` header: name or address, perhaps with a port
    """
def is_loopback(name: str) -> bool:
    """Does it always mean this computer itself?

    Args:
        name: Name or address
    """

class Door:
    "Who may come in"
    token: Any
    everywhere: bool
    names: Any
    def __init__(self, host: str = '127.0.0.1', token: str | None = None, names: tuple = ...) -> None:
        """
        Args:
            host: Where we listen; '', '0.0.0.0' or '::': all addresses
            token: 8 characters or more that need no quoting in a URL; `None`: a new one
            names: Other names of ours, such as that of a proxy before us
        """
    def check_token(self, given: str | None) -> None:
        """Raises `Refused` (403) when it is not the right one

        Args:
            given: By the browser
        """
    def knows(self, name: str) -> bool:
        """Is this one of our names?

        Args:
            name: Name or address
        """
    def check_host(self, hosts: list) -> Any:
        """Raises `Refused` (400, 403) when the browser wanted to go elsewhere

        Args:
            hosts: All headers `Host` of a request
        """
    def check_origin(self, origin: str | None, host: str) -> None:
        """Raises `Refused` (403) when a page of another site has sent it

        Args:
            origin: `None`: the browser does not tell, or it is no browser
            host: Header `Host` of the same request
        """

class Wire(io.RawIOBase):
    "What comes through a socket, for so long and for so many bytes"
    sock: Any
    until: Any
    left: int
    def __init__(self, sock: Any) -> None:
        """
        Args:
            sock: A TCP connection
        """
    def readable(self) -> bool: ...
    def allow(self, seconds: float, size: int) -> None:
        """What may come next

        Args:
            seconds: From now on
            size: Bytes
        """
    def readinto(self, buffer: Any) -> int:
        "Read some, as `io` wants it; raises `Refused` (408, 431) beyond the limits"
def query_of(text: str) -> dict:
    """The last value of each name; raises `Refused` (400)

    Args:
        text: Behind the `?`
    """
def body_length(method: str, headers: Any, most: int = ...) -> int:
    """How long the body is; raises `Refused` (400, 411, 413)

    Args:
        method: 'GET' or 'POST'
        headers: Of the request, as `http.server` reads them
        most: Bytes
    """

@dataclass
class Reply:
    "What a browser gets"
    body: bytes = ...
    kind: str = ...
    status: int = ...
    headers: dict = ...
    more: Any = ...
    def packed(self, keep: bool) -> bytes:
        """As it goes over the wire

        Args:
            keep: Does the connection stay open?
        """

__all__ = ['Refused', 'name_of', 'is_loopback', 'Door', 'Wire', 'query_of', 'body_length', 'Reply']
