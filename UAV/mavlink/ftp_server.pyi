"Offer pictures, recordings and the definition file to any MAVLink FTP client, as fast as the link takes them."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.ftp_sessions import FtpSessions
from UAV.utils.file_tree import FileTree
from typing import Any

FILE_TRANSFER_PROTOCOL: int

class FtpPace:
    "How fast a peer gets its bursts, all of them together"
    first: int
    most: int
    seconds: float
    frame: int
    slack: float
    forget: float
    floor: float
    rate: Any
    frames: Any
    due: Any
    sent: int
    def __init__(self, floor: float) -> None:
        """
        Args:
            floor: Bytes a second that the peer gets in any case
        """
    def begin(self, session: Any, offset: int, now: float) -> int:
        "A burst is asked for: how many frames it may have"
    def pay(self, size: int, now: float) -> None:
        "A frame with so many bytes of data was sent"
    def ended(self, session: Any, offset: int) -> None:
        "A burst has been sent up to `offset`"

class FtpServer:
    "Answers the FILE_TRANSFER_PROTOCOL requests that one component gets"
    most_waiting: int
    most_each: int
    linger: float
    patience: float
    component: Any
    files: Any
    sessions: FtpSessions
    def __init__(self, component: Any, files: FileTree | None = None) -> None:
        """
        Args:
            component: Sends the answers; its `pace` is what each peer gets at least, its `check_guard` allows changes
            files: What it offers
        """
    def close(self) -> Any:
        "End the thread, and close all files; safe to call twice"
    def take(self, msg: Any) -> None:
        """A request has come; it is dropped when too many wait, and its sender asks again

        Args:
            msg: A FILE_TRANSFER_PROTOCOL
        """
def no_media(name: str) -> bool:
    "Is this neither the name of a picture nor of a recording?"

__all__ = ['FtpPace', 'FtpServer', 'no_media', 'FILE_TRANSFER_PROTOCOL']
