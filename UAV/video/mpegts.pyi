"Send MPEG-TS over UDP and TCP: VLC and QGroundControl play it, and a receiver may begin in the middle."
# Written by .ci/stubs.py from the live classes: do not edit.
import socket
from UAV.video.sockets import UDPSink
from UAV.video.units import AccessUnit, Sink
from typing import Any
from typing_extensions import Self

def add_video(container: Any, unit: AccessUnit) -> Any:
    """A stream for units like this one, which go into it as they are; raises `av.FFmpegError`

    Args:
        container: An output container of PyAV
        unit: The first one, a key picture
    """
def as_packet(unit: AccessUnit, stream: Any, ticks: int, duration: int = 0) -> Any:
    """The unit as PyAV's containers take it

    Args:
        unit: What to send, or to keep
        stream: From `add_video`
        ticks: When it is shown, in the clock of the container
        duration: How long, if known
    """

class TSMuxer:
    "Puts access units into an MPEG transport stream"
    name: str
    codec: Any
    def __init__(self, name: str = 'video') -> None:
        """
        Args:
            name: Of the program; players show it as the title
        """
    def close(self) -> None:
        "Give back what FFmpeg holds"
    def mux(self, unit: AccessUnit) -> bytes:
        """Its packets, 188 bytes each; empty before the first key picture

        Args:
            unit: The next picture
        """

class TSSender(UDPSink):
    "Sends MPEG-TS over UDP to one address or multicast group"
    kind: str
    size: int
    burst: int
    pause: float
    def __init__(self, host: str, port: int, *, ttl: int = ..., interface: str = ..., name: str = ...) -> None:
        """
        Args:
            host, port, kwargs: As for `UDPSink`
        """
    def end(self) -> None:
        "Give back what FFmpeg holds"
    def send(self, unit: AccessUnit) -> None:
        "One picture, in datagrams"

class TSClient(Sink):
    "One player of a `TSServer`"
    most: int
    patience: float
    buffer: int
    sock: socket.socket
    def __init__(self, sock: socket.socket, name: str, left: Any) -> None:
        """
        Args:
            sock: Its connection
            name: For people
            left: Called with this client when it has gone
        """
    def close(self, timeout: float = 5.0) -> None:
        """Send what waits, and hang up

        Args:
            timeout: s that the units which wait may take
        """
    def send(self, unit: AccessUnit) -> None:
        "One picture; may take as long as `patience`"
    def end(self) -> None:
        "Hang up, and tell the server"
    def has_left(self) -> bool:
        "Has the other side hung up? What it says is read, and ignored"
    def cut(self) -> None:
        "Hang up, also when it does not read"

class TSServer:
    "Sends MPEG-TS to all who connect over TCP; the encoder works only while there are some"
    encoder: Any
    most: int
    clients: list
    port: Any
    def __init__(self, encoder: Any, port: int = 0, host: str = '', most: int = 16) -> None:
        """Raises `OSError` when the port is taken

        Args:
            encoder: Has `add(sink)`, `remove(sink, wait)` and `key_frame()`
            port: TCP port; 0 is a free one
            host: Our own address, when not all of them
            most: Players at a time; more are turned away
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "Hang up on all, and give the port back; may be called twice"

__all__ = ['add_video', 'as_packet', 'TSMuxer', 'TSSender', 'TSClient', 'TSServer']
