"The rules of RTSP as plain values, without sockets: requests, transports, sessions."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.passwords import Digest
from UAV.video.rtp import RTPStream
from collections.abc import Generator
from dataclasses import dataclass
from typing import Any

reasons: dict

class RTSPError(Exception):
    "What was asked cannot be; `status` says why (RFC 2326, section 11), `headers` go with the answer"
    status: int
    headers: Any
    def __init__(self, status: int, headers: dict | None = None) -> None: ...

@dataclass
class Request:
    "What a player asks"
    method: str
    uri: str
    headers: dict = ...
    body: bytes = ...
    @property
    def path(self) -> str:
        "The name in the URI; raises `RTSPError`"
def parse_head(head: bytes) -> Request:
    """The request that it begins; raises `RTSPError`

    Args:
        head: All before the empty line
    """

@dataclass
class Interleaved:
    "A packet inside the RTSP connection (RFC 2326, section 10.12)"
    channel: int
    data: bytes

class RequestReader:
    "Cuts a stream of bytes into requests and interleaved packets"
    most_head: int
    most_body: int
    def __init__(self) -> None: ...
    def feed(self, data: bytes) -> Generator[Any, None, None]:
        "All that is complete with `data`, one after the other; raises `RTSPError`, and then nothing more can be read"

@dataclass
class Response:
    "What we answer"
    status: int = ...
    headers: dict = ...
    body: str = ...

@dataclass(frozen=True)
class Transport:
    "How packets go: inside the connection or by UDP; to two channels, or to two ports of the player"
    tcp: bool
    pair: tuple
    def header(self, ports: tuple, ssrc: int) -> str:
        """The `Transport` header of our answer

        Args:
            ports: Our own UDP ports
            ssrc: Of the RTP stream
        """
def parse_transport(header: str) -> Transport | None:
    """The first transport that we have

    Args:
        header: What the player offers
    """

class Session:
    "One player's way from DESCRIBE to PLAY; `state` is init, ready or playing"
    track: str
    videos: Any
    digest: Digest | None
    ports: tuple
    timeout: float
    nonce: Any
    heard: float
    state: str
    path: Any
    transport: Any
    id: Any
    rtp: RTPStream
    def __init__(self, videos: Any, digest: Digest | None = None, ports: tuple = ..., timeout: float = 60.0) -> None:
        """
        Args:
            videos: `VideoFormat`s by path
            digest: Checks passwords
            ports: Our UDP ports, for RTP and RTCP
            timeout: s without a sign of life
        """
    def overdue(self, now: float) -> bool:
        "Has the client been silent longer than `timeout`, at `now` (monotonic s)?"
    def answer(self, request: Request) -> Response:
        """Our answer; afterwards `state`, `path` and `transport` say what is to be done

        Args:
            request: What the player asks
        """

__all__ = [
    'reasons', 'RTSPError', 'Request', 'parse_head', 'Interleaved', 'RequestReader', 'Response', 'Transport',
    'parse_transport', 'Session',
]
