"Read and write the 251 bytes of a FILE_TRANSFER_PROTOCOL message: a request, its answer, and a listing."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.jail import FileEntry
from UAV.wire.dialect import MAVError
from dataclasses import dataclass
from enum import IntEnum
from typing import Any


class FtpOp(IntEnum):
    NONE = 0
    TERMINATE_SESSION = 1
    RESET_SESSIONS = 2
    LIST_DIRECTORY = 3
    OPEN_FILE_RO = 4
    READ_FILE = 5
    CREATE_FILE = 6
    WRITE_FILE = 7
    REMOVE_FILE = 8
    CREATE_DIRECTORY = 9
    REMOVE_DIRECTORY = 10
    OPEN_FILE_WO = 11
    TRUNCATE_FILE = 12
    RENAME = 13
    CALC_FILE_CRC32 = 14
    BURST_READ_FILE = 15
    LIST_DIRECTORY_WITH_TIME = 16
ACK: int
NAK: int

class FtpCode(IntEnum):
    NONE = 0
    FAIL = 1
    FAIL_ERRNO = 2
    INVALID_DATA_SIZE = 3
    INVALID_SESSION = 4
    NO_SESSIONS_AVAILABLE = 5
    EOF = 6
    UNKNOWN_COMMAND = 7
    FILE_EXISTS = 8
    FILE_PROTECTED = 9
    FILE_NOT_FOUND = 10

class FtpError(MAVError):
    "A file operation that was refused"
    code: int
    errno: int
    def __init__(self, code: int, errno: int = 0, what: str = '') -> None:
        """
        Args:
            code: As the guide numbers them
            errno: The system's, when the code is FAIL_ERRNO
            what: What was tried
        """
def ftp_error(error: Exception) -> FtpError:
    """The error that a client is told

    Args:
        error: What went wrong
    """
most_data: int

@dataclass(frozen=True)
class FtpFrame:
    "A request or an answer"
    seq: int
    opcode: int
    session: int = ...
    size: int = ...
    req_opcode: int = ...
    burst_complete: int = ...
    offset: int = ...
    data: bytes = ...
    def pack(self) -> bytes:
        "The 251 bytes; raises `ValueError` when something does not fit"
    def ack(self, data: bytes = b'', **fields: Any) -> FtpFrame:
        "The answer to this request"
    def nak(self, error: Exception) -> FtpFrame:
        "The refusal of this request"
    def answers(self, request: FtpFrame) -> bool:
        "Is this the answer to `request`? (In a burst the numbers go on.)"
    @property
    def error(self) -> FtpError | None:
        "Why it was refused; `None` when it was not"
    @property
    def paths(self) -> list:
        "The texts in the data of a request, at least one"
def read_ftp(payload: Any) -> FtpFrame:
    """The frame in a payload; it may be nonsense, but it can always be read

    Args:
        payload: Of a message; what is missing at its end is zero
    """
def path_data(*paths: Any) -> bytes:
    "The data of a request for these paths; raises `ValueError` when they are too long"
def entry_data(entry: FileEntry, with_time: bool) -> bytes:
    "An entry as it goes into a listing"
def listing(entries: list, index: int, with_time: bool = False) -> bytes:
    """As many entries as fit; empty when there are no more

    Args:
        entries: All there are
        index: Of the first one that is wanted
        with_time: As LIST_DIRECTORY_WITH_TIME has it
    """
def read_listing(data: bytes) -> list:
    """A `FileEntry` for each entry, `None` for one to be skipped

    Args:
        data: Of an answer
    """
def ftp_crc(data: bytes, crc: int = 0) -> int:
    """The CRC32 of MAVLink FTP

    Args:
        data: The next part
        crc: Of all before it
    """

__all__ = [
    'FtpOp', 'ACK', 'NAK', 'FtpCode', 'most_data', 'FtpError', 'ftp_error', 'FtpFrame', 'read_ftp', 'path_data',
    'entry_data', 'listing', 'read_listing', 'ftp_crc',
]
