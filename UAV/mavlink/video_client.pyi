"Ask a camera which video streams it has, and watch one from Python."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False)
class Stream:
    "A video stream of a camera, as VIDEO_STREAM_INFORMATION tells it"
    id: int
    name: str
    kind: str
    codec: str
    width: int
    height: int
    rate: float
    bitrate: int
    hfov: int
    uri: str
    running: bool
    thermal: bool = ...
def stream_of(msg: Any) -> Stream:
    """What a message tells of a stream

    Args:
        msg: A VIDEO_STREAM_INFORMATION
    """
def player_url(stream: Stream) -> str:
    """What a `Player` on this computer opens; raises `ValueError` for a URI that leads elsewhere

    Args:
        stream: As `streams` gives it
    """

__all__ = ['Stream', 'stream_of', 'player_url']
