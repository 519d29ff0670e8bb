"Write the commands of a Viewsheen gimbal camera, and read its reports, as bytes."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.values import Value
from dataclasses import dataclass
from typing import Any, NamedTuple

def crc16(data: bytes) -> int:
    "CRC-16/MODBUS"
MARK: bytes
ZEROS: bytes
def sealed(body: bytes, length: int) -> bytes:
    """The frame around `body`

    Args:
        length: What the frame says of its body's length
    """
MAIN: int
THERMAL: int
def command_frame(number: int, data: bytes = b'', sensor: int = ...) -> bytes:
    """A command; raises `ValueError`

    Args:
        number: Of the command, 0..255
        data: At most six bytes
    """
def rate_frame(yaw: float = 0.0, pitch: float = 0.0) -> bytes:
    """Turn, for about 50 ms; raises `ValueError`

    Args:
        yaw: Degrees a second, to the right
        pitch: Degrees a second, up
    """
AIRFRAME: int
GEODETIC: int
def yaw_frame(angle: float, frame: int = ...) -> bytes:
    """Look into this direction; raises `ValueError`

    Args:
        angle: Degrees, clockwise; any number of turns
    """
def pitch_frame(angle: float) -> bytes:
    """Look up or down; raises `ValueError`

    Args:
        angle: Degrees from the horizon; -100..60, beyond that the nearest
    """
def track_frame(x: float, y: float, width: float, height: float) -> bytes:
    """Follow what is in this box; raises `ValueError`

    Args:
        x, y: Middle of the box, 0..1
        width, height: Of the box, 0..1
    """
def tap_zoom_frame(x: float, y: float) -> bytes:
    """Look to this point of the picture, and zoom in ×2; raises `ValueError`

    Args:
        x, y: 0..1
    """
def zoom_frame(times: float) -> bytes:
    """Zoom to this magnification; raises `ValueError`

    Args:
        times: 1 is the widest
    """
ACTIONS: dict
def action_frame(verb: str, word: str, number: int = 0) -> bytes:
    """Have the camera do something; raises `ValueError`

    Args:
        verb: One of `ACTIONS`
        word: One of its words
        number: A count, or seconds: 0..255
    """
FORWARD: bytes
WIDEST: bytes
STOP_TRACKING: bytes
LOOK_DOWN: bytes
def palette_frame(number: int) -> bytes:
    """Colours of the thermal camera; raises `ValueError`

    Args:
        number: 0..14
    """

@dataclass(frozen=True, repr=False, eq=False)
class Report(Value):
    "How the gimbal is held, as it reports itself"
    kind: int = ...
    tracking: int = ...
    mode: int = ...
    pitch: float = ...
    magnetic_yaw: float = ...
    yaw: float = ...

@dataclass(frozen=True, repr=False, eq=False)
class RangeReport(Value):
    "What the laser range finder measured"
    ok: bool = ...
    distance: float = ...
    height: float = ...
    lon: float = ...
    lat: float = ...
IDENTITY: bytes
def report_frame(report: Any) -> bytes:
    """The frame that a gimbal sends

    Args:
        report: A `Report` or a `RangeReport`
    """
def parse_report(body: bytes) -> Report | RangeReport | None:
    """What a gimbal reports; `None`: nothing that we know

    Args:
        body: As `ViewsheenReader` gives it
    """

class Command(NamedTuple):
    number: Any
    data: Any
    sensor: Any
def parse_command(body: bytes) -> Command | None:
    """A command as the gimbal hears it; `None`: it is none

    Args:
        body: As `ViewsheenReader` gives it
    """

class ViewsheenReader:
    "Cuts frames out of a stream; `feed` it as the bytes come"
    most: int
    skipped: int
    def __init__(self) -> None: ...
    def feed(self, data: bytes) -> list:
        """The bodies of all frames that are complete now

        Args:
            data: What came
        """

__all__ = [
    'MARK', 'ZEROS', 'MAIN', 'THERMAL', 'AIRFRAME', 'GEODETIC', 'ACTIONS', 'FORWARD', 'WIDEST', 'STOP_TRACKING',
    'LOOK_DOWN', 'IDENTITY', 'Command', 'crc16', 'sealed', 'command_frame', 'rate_frame', 'yaw_frame', 'pitch_frame',
    'track_frame', 'tap_zoom_frame', 'zoom_frame', 'action_frame', 'palette_frame', 'Report', 'RangeReport',
    'report_frame', 'parse_report', 'parse_command', 'ViewsheenReader',
]
