"The server's side of one RTSP player: what it is sent, by UDP or TCP, and what it asks meanwhile."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.rtp import RTPStream
from UAV.video.rtsp import RequestReader, Session
from UAV.video.sockets import Outbox
from UAV.video.units import AccessUnit, Sink
from collections import deque
from logging import Logger
from typing import Any

log: Logger

class Viewer(Sink):
    "Gives one player its pictures; a subclass has `deliver(packets, report)`"
    rtp: RTPStream
    on_end: Any
    codec: Any
    stopped: bool
    def __init__(self, rtp: RTPStream, name: str, on_end: Any = ...) -> None:
        """
        Args:
            rtp: Of this player's session
            name: For people
            on_end: Called on our thread when nothing more will come
        """
    def end(self) -> None:
        "Tell the connection"
    def send(self, unit: AccessUnit) -> None:
        "One picture, in packets; raises `ConnectionAbortedError` when the codec is another one"
    def stop(self) -> None:
        "Nothing goes out any more; returns at once"

class UDPViewer(Viewer):
    "By UDP"
    sockets: tuple
    addresses: tuple
    def __init__(self, rtp: Any, name: Any, on_end: Any, sockets: tuple, addresses: tuple) -> None:
        """
        Args:
            rtp, name, on_end: As for `Viewer`
            sockets: Ours, for RTP and RTCP
            addresses: The player's, for RTP and RTCP
        """
    def deliver(self, packets: list, report: bytes) -> None:
        "Send the packets of one picture, and a report when it is not empty"

class InsideViewer(Viewer):
    "Inside the RTSP connection"
    outbox: Outbox
    channels: tuple
    alive: Any
    def __init__(self, rtp: Any, name: Any, on_end: Any, outbox: Outbox, channels: tuple, alive: Any = ...) -> None:
        """
        Args:
            rtp, name, on_end: As for `Viewer`
            outbox: Of the connection
            channels: For RTP and RTCP
            alive: Told when the player has taken a picture
        """
    def deliver(self, packets: list, report: bytes) -> None:
        "Send the packets of one picture and a report, and wait until the player has taken them"

class Connection:
    "One player of an RTSP server"
    server: Any
    sock: Any
    address: tuple
    session: Session
    outbox: Outbox
    reader: RequestReader | Any
    asked: deque
    busy: bool
    viewer: Any
    refused: int
    def __init__(self, server: Any, sock: Any, address: tuple) -> None:
        """
        Args:
            server: An `RTSPServer`
            sock: The connection, which does not block
            address: Of the player: host, port …
        """
    @property
    def udp_addresses(self) -> tuple:
        "Where the player wants RTP, and RTCP"
    def close(self) -> None:
        "Goodbye; may be called twice"
    def watch(self) -> None:
        "Wait for requests, and for room in the socket while something waits in the outbox"
    def ready(self, events: int) -> None:
        "Called by the loop"

__all__ = ['log', 'Viewer', 'UDPViewer', 'InsideViewer', 'Connection']
