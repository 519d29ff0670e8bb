"Turn what you type into links, sizes, addresses and streams, or say in one sentence what is wrong with it."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

def links(connection: str) -> list:
    """The connection strings in it; a number after a comma is a baud rate

    Args:
        connection: Connection strings with commas between them
    """
def folders(text: str | None) -> list:
    """The folders in it; raises `ValueError`

    Args:
        text: Folders with commas between them; `None`: none
    """
def picture_size(text: str | None) -> tuple | None:
    """(width, height) in px

    Args:
        text: '1280x720'; `None`: what the camera has
    """
def host_port(text: str) -> tuple:
    """(host, port) of a viewer

    Args:
        text: HOST:PORT; an IPv6 address in brackets
    """
def video_format(
        codec: str = 'h264', size: str | None = None, rate: float = 15.0, bitrate: float | None = None,
) -> dict:
    """The same as arguments of `Camera.add_stream`

    Args:
        codec: One of `codecs`
        size: As for `picture_size`
        rate: Pictures in a second
        bitrate: Mbit/s
    """
def wanted_streams(rtsp: int = 8554, rtp: str | None = None, mpegts: str | None = None, tcp: int | None = None) -> list:
    """(kind, host, port) of each stream

    Args:
        rtsp: Port of an RTSP server; 0 a free one, -1 none
        rtp: HOST:PORT that gets RTP
        mpegts: HOST:PORT that gets MPEG-TS
        tcp: Port where MPEG-TS is to be had; 0 a free one
    """
def mounting(text: str | None) -> tuple | None:
    """Roll, pitch and yaw of the camera from the vehicle's nose, degrees

    Args:
        text: 'down', 'forward' or 'ROLL,PITCH,YAW'; `None`: not known
    """
def camera_id(component: int) -> int:
    """`component`; raises `ValueError` unless it is one of a camera's

    Args:
        component: A component id
    """
def address(host: str | None) -> str | None:
    """`host`; raises `ValueError` unless it may be one

    Args:
        host: Address or name of this machine
    """
def sentence(error: Exception) -> str:
    """An error in one line

    Args:
        error: What was raised
    """
@contextmanager
def or_exit(program: str) -> Generator[Any, None, None]:
    """For a `with`: what cannot be opened ends the program, in one sentence

    Args:
        program: Its name
    """

__all__ = [
    'links', 'folders', 'picture_size', 'host_port', 'video_format', 'wanted_streams', 'mounting', 'camera_id',
    'address', 'sentence', 'or_exit',
]
