"Turn the messages of a camera into plain values and short words that the panel shows."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def printable(raw: Any) -> str:
    """What can be printed of it, up to its first 0

    Args:
        raw: Bytes, a list of them, or a text
    """
def text_of(raw: Any) -> str:
    """A name off the wire, for people

    Args:
        raw: As for `printable`
    """
def flags_of(info: Any) -> list:
    "Names of the CAMERA_CAP_FLAGS of a CAMERA_INFORMATION, or of `None`"
def modes_of(can: list) -> list:
    "The modes that a camera with these flags can be in"
def version_of(number: int) -> str:
    "A firmware version, major to dev; empty when it is not known"
def about_camera(info: Any) -> dict:
    """What there is to say of a camera, as `{what: text}`

    Args:
        info: A CAMERA_INFORMATION, or `None`
    """
def settings_of(msg: Any) -> dict:
    """Mode, zoom and focus; `None` when unknown

    Args:
        msg: A CAMERA_SETTINGS, or `None`
    """
def capture_of(msg: Any, ago: float = 0.0) -> dict:
    """What a camera takes: `capturing` is '', 'single' or 'interval', `recording` is `None` or its seconds

    Args:
        msg: A CAMERA_CAPTURE_STATUS, or `None`
        ago: s since it came
    """
def size_of(mib: float) -> str:
    "A size in words"
def storage_of(msgs: Any) -> dict | None:
    """Free and total MiB, and a text; `None` when nothing is known

    Args:
        msgs: A STORAGE_INFORMATION of each storage
    """
def battery_of(msg: Any) -> int | None:
    """What is left, %; `None` when unknown

    Args:
        msg: A BATTERY_STATUS, or `None`
    """

class Texts:
    "The last texts of a component, put together"
    most: int
    longest: int
    lines: Any
    def __init__(self) -> None: ...
    def add(self, msg: Any, at: float | None = None) -> None:
        """Take a text, or a piece of one

        Args:
            msg: A STATUSTEXT
            at: When, s since 1970; `None`: now
        """
def picture_of(msg: Any, key: int = -1) -> dict:
    """A picture that was announced: number, name of its file, and thumbnail

    Args:
        msg: A CAMERA_IMAGE_CAPTURED
        key: Of its thumbnail; -1: there is none
    """
STATUSTEXT: int
BATTERY_STATUS: int

class CameraTold:
    "All that a camera has told"
    most: int
    newest: dict
    came: dict
    storages: dict
    texts: Texts
    pictures: Any
    def __init__(self) -> None: ...
    def add(self, msg: Any) -> None:
        "Keep a message"
    def knows(self, msg: Any) -> bool:
        "Has this CAMERA_IMAGE_CAPTURED come before?"
    def add_picture(self, msg: Any, key: int = -1) -> None:
        """Keep it among the last ones

        Args:
            msg: A CAMERA_IMAGE_CAPTURED that is news
            key: Of its thumbnail; -1: there is none
        """
    def restarts(self, msg: Any) -> bool:
        "Does this message come from a camera that has begun anew since the last one of its kind?"
    def is_other(self, msg: Any) -> bool:
        "Is this CAMERA_INFORMATION from another kind of camera than the last one?"
    def status(self) -> dict:
        "What there is to show"

__all__ = [
    'STATUSTEXT', 'BATTERY_STATUS', 'printable', 'text_of', 'flags_of', 'modes_of', 'version_of', 'about_camera',
    'settings_of', 'capture_of', 'size_of', 'storage_of', 'battery_of', 'Texts', 'picture_of', 'CameraTold',
]
