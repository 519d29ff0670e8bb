"Answer each request of MAVLink FTP, and keep account of the files that each client has open."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
from UAV.utils.file_tree import FileTree
from UAV.wire.ftp_frames import FtpFrame
from collections.abc import Generator
from typing import Any


class FtpSession:
    "A file that one peer has open"
    file: Any
    size: int
    writes: bool
    used: float
    def __init__(self, file: Any, size: int, writes: bool, used: float) -> None:
        """
        Args:
            file: Open, in bytes
            size: Bytes that can be read
            writes: Was it opened for writing?
            used: When it was used last
        """
    def read(self, offset: int, size: int) -> bytes:
        "A part of the file, perhaps less than `size`; raises `FtpError`, EOF among them, and `OSError`"

class FtpJob:
    "A request that is answered in many steps: `frames` gives answers, and `None` after a step that has none"
    peer: tuple
    request: FtpFrame
    key: tuple
    frames: Any
    def __init__(self, peer: tuple, request: FtpFrame, key: tuple, frames: Any = None) -> None: ...

class FtpSessions:
    "Who has which file open, and what each request is answered"
    each: int
    most: int
    idle: float
    dead: float
    repeat: float
    files: FileTree
    clock: Any
    log: logging.Logger
    open: dict
    def __init__(self, files: FileTree, clock: Any = ...) -> None:
        """
        Args:
            files: What there is
            clock: Gives seconds
        """
    def end(self, key: tuple) -> None:
        "Close a session, if it is there"
    def end_all(self, peer: tuple | None = None) -> None:
        "Close the sessions of a peer, or all"
    def begin(self, peer: tuple, path: str, mode: str, number: int = 0) -> tuple:
        """Open a file for a peer: `(number, FtpSession)`; raises `FtpError` and `OSError`

        Args:
            peer: Who asks
            path: As it came, without the component
            mode: As for `FileTree.open`
            number: That the peer wants; 0: we choose one
        """
    def find(self, peer: tuple, number: int) -> FtpSession:
        "A session that is open; raises `FtpError`"
    def sweep(self) -> None:
        "Close what was not used for long"
    def answer(self, peer: tuple, request: FtpFrame, guard: Any = ...) -> FtpFrame | FtpJob | None:
        """The answer to a request; `None`: there is none

        Args:
            peer: `(system, component)` that asks
            guard: Called before anything is changed; raises `PermissionError`
        """
    def burst(self, job: FtpJob, most: int) -> Generator[Any, None, None]:
        """The frames of a burst, one by one; it ends early when its session is closed

        Args:
            job: A burst
            most: Frames, at least 1
        """
    def checksum(self, job: FtpJob) -> Generator[Any, None, None]:
        """Steps with no answer, and then the answer

        Args:
            job: Its `request` may be replaced by a newer one for the same file
        """
ftp_operations: dict
def operation(op: int, writes: bool = False) -> Any:
    """Mark the method that carries out an operation: it returns an answer or raises

    Args:
        op: Which one
        writes: Does it change anything?
    """
def path_in(request: FtpFrame) -> str:
    "The path that a request is about"

__all__ = ['ftp_operations', 'FtpSession', 'FtpJob', 'FtpSessions', 'operation', 'path_in']
