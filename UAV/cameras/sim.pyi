"A camera without hardware: it looks at a simulated world, and its pictures tell where it looks."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.camera import Camera
from UAV.cameras.lens import Focus, Lens, View
from UAV.cameras.sim_world import SimWorld
from UAV.cameras.values import CameraInformation, Frame, Pose
from collections.abc import Sequence
from pathlib import Path
from typing import Any

def sim_information(model: str, width: int, height: int) -> CameraInformation:
    "What a `SimCamera` says it is; raises `ValueError` for a size (px) that cannot be made"

class SimCamera(Camera):
    "A camera in a `SimWorld`, with zoom, focus, modes and parameters"
    modes: Sequence
    declared: list
    north: float
    east: float
    altitude: float
    roll: float
    pitch: float
    yaw: float
    attitude: Any
    origin: tuple
    capture_time: float
    clock: Any
    mount: Any
    world: Any
    plugged_in: bool
    lens: Lens | Any
    focus: Focus | Any
    number: Any
    def __init__(
            self, width: int = 640, height: int = 480, model: str = 'SimCamera', world: SimWorld | None = None,
            north: float = 0.0, east: float = 0.0, altitude: float = 30.0, roll: float = 0.0, pitch: float = -20.0,
            yaw: float = 0.0, attitude: Any = None, origin: tuple = ..., frame_rate: float = 15.0,
            folder: str | Path | None = None, quota: float | None = None, storages: list | None = None, seed: int = 0,
            capture_time: float = 0.0, clock: Any = ..., mount: Any = None,
    ) -> None:
        """
        Args:
            width: px
            height: px
            model: As in CameraInformation
            world: What it looks at; `None` is the world of `seed`
            north, east, altitude: Where it is: m from the origin, and above the ground
            roll, pitch, yaw: Where it looks, degrees
            attitude: Function that gives (roll, pitch, yaw) in degrees, in place of the three above
            origin: Latitude, longitude, height above sea of the origin
            frame_rate: Frames per second of simulated time
            folder, quota, storages: As for Camera
            seed: Which world
            capture_time: Seconds that a still picture takes
            clock: Gives the time stamps, s since 1970
            mount: What it hangs on, such as a `SimGimbal`: its `look` says all that `look` below does
        """
    def look(self) -> tuple:
        "North, east and altitude (m), and roll, pitch and yaw (degrees), now; all of one moment"
    def looks(self) -> tuple:
        "Roll, pitch and yaw now, degrees"
    def view(self, look: tuple | None = None, size: tuple | None = None) -> View:
        """What is in the picture

        Args:
            look: As from `look`; `None`: now
            size: px; `None`: that of a frame
        """
    def pose(self, look: tuple | None = None) -> Pose:
        """Where the camera is and how it is held

        Args:
            look: As from `look`; `None`: now
        """
    def read(self, size: tuple | None = None) -> Frame:
        """The next frame; raises `CameraError` when the camera is closed or unplugged

        Args:
            size: px; `None`: as `information` says
        """
    def read_still(self) -> Frame:
        "The frame of a still picture, after `capture_time`; its size is a parameter"
    def set_camera_mode(self, mode: str) -> None:
        """Image or video; raises `ValueError`

        Args:
            mode: One of `modes`
        """
    def set_camera_zoom(self, kind: str, value: float) -> None:
        """Zoom one of five ways; raises `ValueError`

        Args:
            kind: One of `Lens.kinds`
            value: As for `Lens.zoom`
        """
    def set_camera_focus(self, kind: str, value: float = 0.0) -> None:
        """Focus one of seven ways; raises `ValueError`

        Args:
            kind: One of `Focus.kinds`
            value: As for `Focus.focus`
        """
    def apply_parameter(self, name: str, value: Any) -> dict | None:
        "An automatic exposure chooses the shutter and the sensitivity"
    def plug(self, plugged_in: bool = True) -> None:
        """Pull the cable, or put it back: the camera's `fault`

        Args:
            plugged_in: False: as if it had been pulled off its cable
        """
def find_tags(image: Any) -> dict:
    """Corners (4 x 2, px) of each AprilTag (36h11) in the picture, by its number

    Args:
        image: BGR or grey picture
    """
def locate(image: Any, K: Any, tags: dict) -> tuple | None:
    """Position (north, east, down) and rotation matrix of the camera that took `image`; `None` without tags

    Args:
        image: BGR or grey picture
        K: 3x3 camera matrix, as `View.K`
        tags: Corners of the tags by number, as `SimWorld.tags`
    """

__all__ = ['sim_information', 'SimCamera', 'find_tags', 'locate']
