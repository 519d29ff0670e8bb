"List the files of a camera, show small pictures of them, and pass a file on while it is still on its way."
# Written by .ci/stubs.py from the live classes: do not edit.
import asyncio
from UAV.mavlink.ftp_client import FtpFile
from typing import Any

def small_picture(data: bytes, width: int = 160) -> bytes:
    """It as a small JPEG; raises `ValueError` when it is no picture

    Args:
        data: A JPEG or PNG, or anything else
        width: px
    """

class Fetching:
    "A file of a camera that comes here, and is read from its beginning meanwhile"
    most: int
    piece: int
    sink: Any
    file: FtpFile
    have: int
    given: int
    task: Any
    news: asyncio.Event
    def __init__(self, client: Any, target: tuple, path: str) -> None: ...
    @property
    def size(self) -> Any:
        "Bytes; known when it is open"
    async def open(self) -> None:
        "Ask for it; raises `MAVError`, or `ValueError` for one that is too large"
    async def next(self) -> bytes:
        "Some more of it; nothing at the end. Its last byte comes when the checksum is right; raises `MAVError`"
    async def close(self) -> None:
        "Want it no longer"

__all__ = ['small_picture', 'Fetching']
