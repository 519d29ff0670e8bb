"Read RTP and MPEG-TS: packets in, access units out, each as soon as its last byte has come."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class UnitMaker:
    "Makes access units of the bytes of pictures, from the first key picture on"
    codec: str
    headers: bytes
    number: int
    begun: Any
    lost: int
    def __init__(self, codec: str = 'h264', headers: bytes = b'') -> None:
        """
        Args:
            codec: One of `UAV.video.units.codecs`
            headers: Parameter sets that came another way, as a byte stream
        """
    def __call__(self, data: bytes, taken: float | None = None) -> list:
        """A list of one access unit, or of none

        Args:
            data: A byte stream
            taken: s since 1970; `None` is now
        """
def rtp_parts(packet: bytes) -> tuple | None:
    """`(payload_type, marker, sequence, timestamp, payload)`; `None` when it is no RTP packet

    Args:
        packet: An RTP packet, RFC 3550
    """

class Reorder:
    "Puts packets in the order of their numbers, and waits a little for a missing one"
    most: int
    patience: float
    expected: Any
    def __init__(self) -> None: ...
    def __call__(self, sequence: int, packet: Any) -> list:
        """The packets whose turn it is, each with its `sequence`

        Args:
            sequence: Its number, 0 … 65535
            packet: What is handed out again
        """
def rtp_payload(payload: bytes, codec: str = 'h264') -> bytes:
    """What it adds to the byte stream, RFC 6184 and RFC 7798; raises `ValueError` for what they do not allow here

    Args:
        payload: Of an RTP packet
        codec: One of `UAV.video.units.codecs`
    """

class SenderClock:
    "From the time stamps of RTP to the time of day of the sender"
    since_1900: int
    def __init__(self) -> None: ...
    def report(self, packet: bytes) -> None:
        """Learn from a sender report; other packets are ignored

        Args:
            packet: RTCP
        """
    def utc(self, timestamp: int) -> float | None:
        """s since 1970; `None` before the first report

        Args:
            timestamp: Of an RTP packet, in ticks of 1/90000 s
        """

class RTPReader:
    "RTP packets in, access units out"
    codec: str
    payload_type: int | None
    clock: SenderClock
    def __init__(self, codec: str = 'h264', headers: bytes = b'', payload_type: int | None = None) -> None:
        """
        Args:
            codec: One of `UAV.video.units.codecs`
            headers: Parameter sets, when the description of the stream has them
            payload_type: Only these packets; `None` takes all
        """
    @property
    def lost(self) -> int:
        "How many pictures came in part only"
    def __call__(self, packet: bytes) -> list:
        "The access units that this packet completes"
ts_size: int

class TSReader:
    "The bytes of an MPEG transport stream in, access units out"
    programs: int | None | Any
    pid: Any
    trust: bool
    def __init__(self) -> None: ...
    @property
    def lost(self) -> int:
        "How many pictures came in part only"
    def __call__(self, data: bytes) -> list:
        "The access units that these bytes complete"

__all__ = ['ts_size', 'UnitMaker', 'rtp_parts', 'Reorder', 'rtp_payload', 'SenderClock', 'RTPReader', 'TSReader']
