"Serve the video of a camera to many players at once, by UDP or TCP, with a password or without."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.sockets import Loop
from UAV.video.passwords import Digest
from logging import Logger
from typing import Any
from typing_extensions import Self

log: Logger

class Videos(dict):
    "Encoders by path; `videos[path]` is the format of one, as soon as that is known"
    patience: float
    def __getitem__(self, path: str) -> Any:
        "Its `VideoFormat`; raises `RTSPError` (503) when that is not known in time"

class RTSPServer:
    "Serves videos by RTSP; `with` closes it"
    most: int
    timeout: float
    host: str
    digest: Digest | Any
    videos: Videos
    connections: dict
    helpers: set
    listener: Any
    port: Any
    udp: tuple
    udp_ports: tuple
    loop: Loop
    def __init__(self, port: int = 8554, host: str = '', user: str | None = None, password: str | None = None) -> None:
        """
        Args:
            port: TCP; 0: any that is free
            host: Our own address or name; '': all that we have, IPv4 and IPv6
            user: Who may watch; `None`: all who ask
            password: Of that user
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "End all, and leave nothing behind; may be called twice"
    def add(self, path: str, encoder: Any) -> str:
        """Offer a video, and give its URL; raises `ValueError` when there is one of this name

        Args:
            path: Behind `rtsp://host:port/`
            encoder: An `Encoder`
        """
    def url(self, path: str, host: str | None = None) -> str:
        """What a player must open

        Args:
            path: Of a video
            host: Our address, as the player can reach it; `None`: where we listen, or this computer
        """
    def viewers(self, path: str | None = None) -> int:
        """How many players play it now

        Args:
            path: Of a video; `None`: of all
        """
    def remove(self, path: str) -> None:
        """Offer it no more; its players see the end

        Args:
            path: Of a video; others are ignored
        """

__all__ = ['log', 'Videos', 'RTSPServer']
