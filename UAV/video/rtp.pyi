"Send access units as RTP packets over UDP, and describe the stream in SDP."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.sockets import UDPSink
from UAV.video.units import AccessUnit, VideoFormat
from typing import Any

def fragments(nal: bytes, codec: str = 'h264', size: int = 1388) -> list:
    """A NAL unit cut into payloads: FU-A of RFC 6184, or FU of RFC 7798

    Args:
        nal: A NAL unit
        codec: One of `codecs`
        size: bytes a payload may have
    """
def payloads(unit: AccessUnit, size: int = 1388) -> list:
    """What goes into RTP packets, in order

    Args:
        unit: One picture
        size: bytes a payload may have: 1400 with the RTP header
    """

class RTPStream:
    "Numbers the packets of one stream to one receiver, and reports about it"
    payload_type: int
    size: int
    ssrc: Any
    sequence: Any
    start: Any
    packets_sent: int
    octets_sent: int
    utc_offset: Any
    next_report: Any
    def __init__(self, size: int = 1388) -> None:
        """
        Args:
            size: bytes a payload may have
        """
    def timestamp(self, seconds: float) -> int:
        """The time stamp of that moment

        Args:
            seconds: monotonic
        """
    def packets(self, unit: AccessUnit) -> list:
        """The RTP packets of one picture

        Args:
            unit: One picture
        """
    def report(self, now: float | None = None) -> bytes:
        """An RTCP sender report, with our name (SDES)

        Args:
            now: monotonic s
        """
    def goodbye(self) -> bytes:
        "The last report: the stream has ended (BYE)"
    def due_report(self, now: float | None = None) -> bytes:
        """A sender report, when it is time for one; else nothing

        Args:
            now: monotonic s
        """
def is_report(data: bytes) -> bool:
    """Is it an RTCP sender report or receiver report, as any compound packet begins?

    Args:
        data: A datagram
    """
def sdp(
        format: VideoFormat, host: str = '0.0.0.0', port: int = 0, name: str = 'video', control: str | None = None,
        ttl: int | None = None,
) -> str:
    """A description of the stream

    Args:
        format: With its headers
        host: Where the stream goes: an address
        port: UDP port; 0: RTSP will agree on one
        name: For people
        control: For RTSP: the URL of the stream, relative to that of the whole
        ttl: Of a multicast address
    """
def udp_pair(host: str = '127.0.0.1', family: int = ...) -> tuple:
    """Two UDP sockets on neighbouring ports, the first of them even: for RTP and RTCP

    Args:
        host: Our own address
        family: Or `socket.AF_INET6`, which with the host `::` takes IPv4 as well
    """

class RTPSender(UDPSink):
    "Sends RTP over UDP to one address or multicast group, and RTCP reports to the port after it"
    kind: str
    rtp: RTPStream
    format: Any
    def __init__(self, host: str, port: int, *, ttl: int = ..., interface: str = ..., name: str = ...) -> None:
        """
        Args:
            host, port, kwargs: As for `UDPSink`
        """
    def send(self, unit: AccessUnit) -> None:
        "One picture, and a report when it is time for one"
    def end(self) -> None:
        "Say goodbye, when anything was sent"
    def sdp_file(self, path: Any = None, timeout: float = 5.0) -> str:
        """The description that a player needs; raises `TimeoutError` when there is no picture yet

        Args:
            path: Where to write it
            timeout: s that the encoder may take to know its headers
        """

__all__ = ['fragments', 'payloads', 'RTPStream', 'is_report', 'sdp', 'udp_pair', 'RTPSender']
