"Turn the bytes of a MAVLink frame into a message and back, and read what the bytes alone can tell."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def promised(buf: bytes, pos: int) -> int:
    """Bytes of the frame at `pos`, as its header says; 0 when too few are there to tell, -1 when no frame starts there

    Args:
        pos: Where a frame could start
    """
crc: Any

class Kind:
    "What all frames with the same sender, message id and MAVLink version have in common"
    def __init__(self, frame: bytes) -> None: ...
    def is_whole(self, data: bytes) -> bool:
        "Is `data`, whose header is ours, one good MAVLink 2 frame without a signature?"
def decode(frame: bytes) -> Any:
    """The pymavlink message in `frame`; `None` when its id is not in pymavlink's `mavlink_map`

    Args:
        frame: One whole frame, its CRC checked
    """
def good_length(buf: bytes, pos: int, whole: bool = True) -> int:
    """Bytes of the good frame at `pos`; 0 when more are needed, -1 when this is no frame

    Args:
        pos: Where a frame could start
        whole: Does a frame end where `buf` ends, as in a datagram?
    """
def target(frame: bytes) -> tuple:
    "`(system, component)` that `frame` is for; 0 is all"
def pack(msg: Any, mav: Any) -> bytes:
    """`msg` as a MAVLink 2 frame; raises `struct.error` when a field does not fit

    Args:
        msg: A pymavlink message
        mav: The sender's encoder: its `seq`, `srcSystem` and `srcComponent` go into the frame
    """

__all__ = ['promised', 'crc', 'Kind', 'decode', 'good_length', 'target', 'pack']
