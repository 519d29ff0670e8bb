"Receive encoded pictures from the network: MPEG-TS over UDP and TCP, RTP with an SDP file, RTSP."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from dataclasses import dataclass
from typing import Any
from typing_extensions import Self


class Stopped(Exception):
    "The receiver was told to stop"

class Receiver:
    "Reads access units from the network; `stop`, called from any thread, ends it at once"
    connects: bool
    port: Any
    url: str
    timeout: float
    def __init__(self, url: str, timeout: float = 5.0) -> None:
        """
        Args:
            url: Where the stream is
            timeout: s that it may be silent
        """
    def close(self) -> None:
        "Let go of all sockets; not while another thread reads"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def stop(self) -> None:
        "End what waits, now and later"
    @property
    def lost(self) -> int:
        "How many pictures came in part only"
def listen(host: str, port: int) -> Any:
    """Listen for datagrams; raises `OSError` when the port is taken

    Args:
        host: An address of this machine, or a multicast group; anything else is all addresses
        port: 0 is a free one
    """
def listen_pair(host: str, port: int = 0) -> list:
    """Sockets for RTP and, if possible, for RTCP; raises `OSError`

    Args:
        host: As for `listen`
        port: 0 is a free one, and then an even one
    """
def own_host(place: Any) -> str:
    """The address of a split URL; `@` and nothing are all of ours, as VLC writes them

    Args:
        place: From `urlsplit`
    """

class TSReceiver(Receiver):
    "MPEG-TS, from `udp://HOST:PORT` (ours) or `tcp://HOST:PORT` (the server's)"
    port: Any
    def __init__(self, url: str, timeout: float = 5.0) -> None:
        """
        Args:
            url: `udp://…` or `tcp://…`; port 0 is a free one
            timeout: s that it may be silent
        """
    def close(self) -> None:
        "Let go of all sockets; not while another thread reads"
    def units(self) -> Generator[Any, None, None]:
        "Access units, until the stream ends; raises `OSError`"

class OneSender:
    "Of all who send to a UDP port, the first, until it is silent"
    patience: float
    fits: Any
    address: Any
    def __init__(self, fits: Any) -> None:
        """
        Args:
            fits: Function of a datagram: can it be from such a sender?
        """
    def receive(self, sock: Any) -> bytes:
        "What has come; empty when it is from another sender. Raises `OSError`"

@dataclass
class Media:
    "What an SDP says of its video"
    codec: str
    payload_type: int | None
    host: str = ...
    port: int = ...
    headers: bytes = ...
    control: str = ...
    session_control: str = ...
def read_sdp(text: str) -> Media:
    """The first H.264 or H.265 video of an SDP; raises `ValueError` when it has none

    Args:
        text: SDP, RFC 8866
    """
def rtp_media(url: str) -> Media:
    """What `rtp://HOST:PORT?codec=h265` says; raises `ValueError` for a codec that we do not know

    Args:
        url: `rtp://…`
    """

class RTPReceiver(Receiver):
    "RTP over UDP, from an SDP file, or from `rtp://HOST:PORT` (ours; `?codec=h265` when it is not H.264)"
    connects: bool
    media: Media
    port: Any
    def __init__(self, url: str, timeout: float = 5.0) -> None:
        """
        Args:
            url: Path of an SDP file, or `rtp://…`
            timeout: s that it may be silent
        """
    def close(self) -> None:
        "Let go of all sockets; not while another thread reads"
    def units(self) -> Generator[Any, None, None]:
        "Access units, until the stream is silent; raises `OSError`"

__all__ = [
    'Stopped', 'Receiver', 'listen', 'listen_pair', 'own_host', 'TSReceiver', 'OneSender', 'Media', 'read_sdp',
    'rtp_media', 'RTPReceiver',
]
