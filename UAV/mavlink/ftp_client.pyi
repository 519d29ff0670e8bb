"Download files from a vehicle over any link: what is lost is asked for again, what was cut off goes on, and the checksum is compared."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.camera_client import CameraClient
from UAV.wire.ftp_frames import FtpError as FtpError
from UAV.wire.ftp_parts import FtpParts
from typing import Any


class FtpFile:
    "A file on a vehicle that is being fetched"
    most_holes: int
    most: int
    tries: int
    client: CameraClient
    target: tuple
    path: str
    sink: Any
    start: int
    number: Any
    session: Any
    parts: FtpParts | Any
    silent: Any
    refused: Any
    came: tuple | Any
    saved: Any
    def __init__(self, client: CameraClient, target: tuple, path: str, sink: Any, start: int = 0) -> None: ...
    async def open(self) -> None:
        "Open it, or open it again; raises `FtpError` and `Lost`"
    async def burst(self) -> None:
        "Ask for a burst from the end of what we have, and take it; raises `FtpError`"
    async def fill(self) -> None:
        "Ask for all that is missing before the end; raises `FtpError` and `Lost`"
    async def fetch(self, progress: Any = None) -> None:
        "Get it all; raises `FtpError`, `Lost` and `OSError`"
    async def fetch_checked(self, progress: Any = None) -> Any:
        "Get it all, and compare the checksum; raises `FtpError`, also when it is wrong twice"
async def in_turns(coroutines: list, most: int = 6) -> None:
    """Await all; when one raises, the others are given up

    Args:
        coroutines: To be awaited
        most: At a time
    """

__all__ = ['FtpFile', 'in_turns', 'FtpError']
