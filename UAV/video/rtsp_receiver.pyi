"Receive a live stream from an RTSP server: ask what it has, let it send, and read it."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.receivers import Receiver
from collections.abc import Generator
from typing import Any

transports: tuple

class RTSPReceiver(Receiver):
    "The first H.264 or H.265 video of an RTSP server"
    transport: str | None
    def __init__(self, url: str, timeout: float = 5.0, transport: str | None = None) -> None:
        """
        Args:
            url: rtsp://[USER:PASSWORD@]HOST[:PORT]/PATH
            timeout: s that the server may be silent
            transport: 'tcp' or 'udp'; `None` is TCP, and UDP when the server refuses it
        """
    def units(self) -> Generator[Any, None, None]:
        "Access units, until the stream ends; raises `OSError`"

__all__ = ['transports', 'RTSPReceiver']
