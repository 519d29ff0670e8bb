"Send single packets of MAVLink FTP, see each reply, and put a file together from them."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any, NamedTuple

ftp_head: Any
ack: int
nak: int
terminate: int
reset: int
list_directory: int
open_read: int
read: int
crc: int
burst: int
errors: dict

class FtpPacket(NamedTuple):
    "What is inside a FILE_TRANSFER_PROTOCOL"
    seq: int
    session: int
    opcode: int
    asked: int
    complete: int
    offset: int
    data: bytes
    def error(self) -> str:
        "Name of the error of a NAK, such as 'EOF'; empty for anything else"
def ftp_unpacked(payload: Any) -> FtpPacket:
    "The way back"
def ftp_packed(p: FtpPacket, size: int | None = None) -> bytes:
    "As the 251 bytes of a payload; `size` is how many bytes are wanted, where that is not the length of `data`"
def ftp_path(uri: str) -> str | None:
    "The path of an `mftp://` URI, as QGroundControl asks for it; `None` when it is no such URI"

__all__ = [
    'ftp_head', 'ack', 'nak', 'terminate', 'reset', 'list_directory', 'open_read', 'read', 'crc', 'burst', 'errors',
    'FtpPacket', 'ftp_unpacked', 'ftp_packed', 'ftp_path',
]
