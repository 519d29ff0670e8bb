"`VideoStream` sends a camera's video one of four ways, and knows all that a viewer must know: address, size, state."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.rtsp_server import RTSPServer
from UAV.video.units import VideoFormat
from typing import Any
from typing_extensions import Self

default_ports: dict
senders: dict
def rtsp_server(host: str = '', port: int = 8554) -> RTSPServer:
    """The RTSP server of this process at that port, which `let_go` gives back; raises `OSError` when the port is taken

    Args:
        host: The address that it listens at; all when empty
        port: 0: a free port, and a server of its own
    """
def let_go(server: RTSPServer) -> None:
    """Close the server, unless others use it

    Args:
        server: From `rtsp_server`
    """

class VideoStream:
    "An encoder and the way its pictures take"
    encoder: Any
    kind: str
    name: str
    stream_id: int
    host: Any
    server: Any
    hfov: float
    size: tuple
    on_change: Any
    port: int
    told_uri: str
    running: bool
    sink: Any
    path: Any
    def __init__(
            self, encoder: Any, kind: str = 'rtsp', name: str = 'video', stream_id: int = 1, host: str = '',
            port: int | None = None, server: RTSPServer | None = None, uri: str = '', hfov: float = ..., size: tuple = ...,
            on_change: Any = ...,
    ) -> None:
        """
        Args:
            encoder: An `Encoder`; several streams may share one
            kind: One of `default_ports`
            name: For people; and the path of an RTSP stream
            stream_id: From 1
            host: Where a sender sends to (this machine); the address that a server listens at (all)
            port: Where a sender sends to, or a server listens; `None`: as in `default_ports`, 0: a free one
            server: For RTSP; `None`: that of this process at `port`
            uri: What viewers are told, in place of what we think
            hfov: Horizontal field of view, degrees
            size: Of the frames (px), as long as none was seen
            on_change: Called when it starts or stops
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def viewers(self) -> int:
        "How many watch; a sender does not know, and says 1"
    @property
    def format(self) -> VideoFormat:
        "How it is encoded; what was asked for, as long as nothing was encoded"
    def start(self, host: str | None = None) -> None:
        """Let viewers in, or begin to send; fine when it runs. Raises `OSError` (port taken), or `RuntimeError` (closed)

        Args:
            host: Where a sender sends to from now on; `None`: as before
        """
    def stop(self) -> None:
        "Send the viewers away; fine when it does not run"
    def uri(self, host: str = '127.0.0.1') -> str:
        """What a viewer opens: a URL, or the number of its own port that it is sent to

        Args:
            host: Our address, as the viewer can reach it
        """
    def close(self) -> None:
        "Stop for good, and let go of the server; may be called twice. The encoder stays"

__all__ = ['default_ports', 'senders', 'rtsp_server', 'let_go', 'VideoStream']
