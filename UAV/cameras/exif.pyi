"Write time, position and attitude into a JPEG, where the programs that make maps look for them."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import CameraInformation, Pose
from typing import Any

def segment(payload: bytes) -> bytes:
    "An APP1 segment; raises `ValueError` when the payload is too long for its two bytes of length"
def add_segments(jpeg: bytes, *payloads: bytes) -> bytes:
    """`jpeg` with the payloads in front, in place of a JFIF header; raises `ValueError` when it is no JPEG

    Args:
        jpeg: A JPEG file
        payloads: What goes into APP1 segments, at most 65533 bytes each
    """
def degrees_minutes_seconds(angle: float) -> tuple:
    "`angle` in degrees, as the three fractions EXIF wants, exact to a millionth of a second of arc"
def place_tags(pose: Pose) -> dict:
    "Latitude, longitude and height as tags of EXIF's GPS part"
def gps_tags(pose: Pose, time_utc: float) -> dict:
    "The GPS part of EXIF: tag to value, without what is not known"
def time_tags(time_utc: float) -> dict:
    "The times of EXIF's photographic part: tag to value"
def photo_tags(time_utc: float, size: tuple, focal_length: float) -> dict:
    "The photographic part of EXIF: tag to value"
def in_photo_part(tag: int) -> bool:
    """Whether EXIF has it in the photographic part (EXIF 3.0, table 8), and not in the first one

    Args:
        tag: The number of a tag
    """
def add_tags(block: Any, tags: dict) -> None:
    """Add tags by their names; raises `ValueError` for a name or a value that EXIF does not have

    Args:
        block: Pillow's `Exif`
        tags: Name of the tag to its value
    """
def exif(
        index: int, time_utc: float, size: tuple, pose: Pose | None = None,
        information: CameraInformation | None = None, tags: dict | None = None,
) -> bytes:
    """An EXIF block, ready for `add_segments`; raises `ValueError` for a tag that EXIF does not have

    Args:
        index: Which picture
        time_utc: When it was taken, s since 1970
        size: Width and height, px
        pose: Where it was taken
        information: Which camera took it
        tags: More of them, by their names
    """
def attitude_names(pose: Pose) -> dict:
    "The attitude (degrees) and the heights (m) by the names of Pix4D and of DJI"
def xmp(pose: Pose) -> bytes:
    "The attitude as an XMP block, ready for `add_segments`"
def add_metadata(
        jpeg: bytes, index: int, time_utc: float, pose: Pose | None = None,
        information: CameraInformation | None = None, tags: dict | None = None,
) -> bytes:
    """`jpeg` with EXIF, and with XMP when `pose` is known

    Args:
        jpeg: A JPEG file
        index: Which picture
        time_utc: When it was taken, s since 1970
        pose: Where it was taken
        information: Which camera took it
        tags: More EXIF tags, by their names
    """

class OwnTags:
    "A camera's attribute: EXIF tags for its pictures, name to value; setting it raises `ValueError` as `add_tags` does"

__all__ = [
    'segment', 'add_segments', 'degrees_minutes_seconds', 'place_tags', 'gps_tags', 'time_tags', 'photo_tags',
    'in_photo_part', 'add_tags', 'exif', 'attitude_names', 'xmp', 'add_metadata', 'OwnTags',
]
