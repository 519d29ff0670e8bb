"Write to a player without waiting for it, and send datagrams to one address or many."
# Written by .ci/stubs.py from the live classes: do not edit.
import socket
from UAV.utils.sockets import Loop as Loop, listen_tcp as listen_tcp
from UAV.video.units import Sink
from logging import Logger
from typing import Any

log: Logger

class Outbox:
    "What the other side has not taken yet"
    most: int
    sock: Any
    full: Any
    closed: bool
    def __init__(self, sock: Any, full: Any = ...) -> None:
        """
        Args:
            sock: That does not block
            full: Called when the socket takes no more: watch it, and `flush` when it does
        """
    @property
    def waiting(self) -> int:
        "How many bytes wait"
    def flush(self) -> None:
        "Send what waits, as far as the socket takes it"
    def close(self) -> None:
        "Nothing goes out any more"
    def write(self, data: bytes) -> None:
        """Send it, and keep what cannot be sent now

        Args:
            data: For the other side
        """
    def wait_empty(self) -> bool:
        "Wait until all is sent; false when the connection is closed instead"
def tune(sock: Any) -> None:
    """Small packets at once, little in the system's buffer, and no waiting; raises `OSError`

    Args:
        sock: A TCP connection
    """
def is_group(host: str) -> bool:
    """Is this a multicast address?

    Args:
        host: An address, or a name
    """

class UDPSink(Sink):
    "Sends datagrams to one address or multicast group; a subclass has `send(unit)`"
    kind: str
    ttl: int
    unsent: int
    address: Any
    sock: socket.socket
    def __init__(self, host: str, port: int, ttl: int = 1, interface: str = '', name: str = '') -> None:
        """
        Args:
            host: An address or name, IPv4 or IPv6
            port: UDP port
            ttl: Of multicast: routers it may pass
            interface: For multicast, our own interface: its address (IPv4), or name (IPv6); empty: the usual one
            name: For people
        """
    def close(self, timeout: float = 5.0) -> None:
        """Send what waits, and give the port back

        Args:
            timeout: s that the units which wait may take
        """
    def send_datagram(self, data: bytes, beside: int = 0) -> None:
        """Send it; what the system does not take is counted

        Args:
            data: For the other side
            beside: How far from its port: RTP has another one beside it
        """

__all__ = ['log', 'Outbox', 'tune', 'is_group', 'UDPSink', 'Loop', 'listen_tcp']
