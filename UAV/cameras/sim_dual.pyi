"A simulated camera with two eyes: you see one, have the other in a corner, and learn where it is hottest."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.frames import Frames
from UAV.cameras.lens import View
from UAV.cameras.sim import SimCamera
from UAV.cameras.thermal import ThermalRange
from UAV.cameras.values import Frame
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False, eq=False)
class ThermalFrame(Frame):
    "A frame in the colours of a palette, and the temperatures behind them"
    celsius: Any = ...

class ThermalEye:
    "What `Frames` needs of a camera: the thermal part of a `SimDualCamera`"
    camera: Any
    def __init__(self, camera: Any) -> None: ...
    @property
    def information(self) -> Any: ...
    @property
    def frame_rate(self) -> Any: ...
    @property
    def patience(self) -> Any: ...
    @property
    def fault(self) -> Any: ...
    def set_fault(self, fault: Any, error: Any = None) -> None:
        "Fail as the camera is told to; `fault=None`: work again"
    def read(self) -> Any:
        "The next frame of the thermal eye; raises `CameraError` when the camera is closed or unplugged"

class SimDualCamera(SimCamera):
    "A visible and a thermal camera in one `SimWorld`"
    sources: Sequence
    corner: float
    source: Any
    warm_world: Any
    lenses: dict
    thermal_frames: Frames
    lens: Any
    def __init__(self, width: int = 640, height: int = 480, model: str = 'SimDualCamera', **how: Any) -> None:
        """
        Args:
            width: px
            height: px
            model: As in CameraInformation
            how: As for `SimCamera`
        """
    def close(self) -> None: ...
    def after_fork(self) -> None: ...
    def view(self, look: Any = None, size: Any = None, source: Any = None) -> View:
        "What is in the picture of a source; `None`: of the primary one"
    def temperatures(self, number: int, look: tuple, size: tuple | None = None) -> Any:
        "What the thermal eye measures, °C"
    def set_camera_source(self, primary: str = 'default', secondary: str = 'default') -> None:
        """Choose what is shown; listeners hear of the streams that changed. Raises `ValueError`

        Args:
            primary: 'default', 'rgb' or 'ir'
            secondary: The picture in the corner; 'default': none
        """
    def set_camera_zoom(self, kind: Any, value: Any) -> None:
        "As `SimCamera`; raises `ValueError` while the thermal camera, which does not zoom, is primary"
    def reset_camera_settings(self) -> None:
        "As `SimCamera`, and the visible picture"
    def read_still(self) -> Frame:
        "The frame of a still picture, of the primary source alone"
    def read_thermal(self) -> ThermalFrame:
        "The next frame of the thermal eye; raises `CameraError` when the camera is closed or unplugged"
    def make_encoder(self, codec: str, size: tuple | None, rate: float, bitrate: int | None, source: str = '') -> Any:
        "An encoder of what is shown, or of the thermal eye ('ir')"
    def add_streams(self, **how: Any) -> tuple:
        """Both streams: what is shown, and heat

        Args:
            how: As for `Camera.add_stream`
        """
    def shows(self, stream: Any) -> dict:
        """What is in a stream now: is it `thermal`, and its `hfov`, degrees

        Args:
            stream: One of `streams`
        """
    def thermal_range(self, stream_id: int = 0) -> ThermalRange:
        """The hottest and the coldest place of the newest thermal frame; raises `ValueError` for a stream without heat

        Args:
            stream_id: 0: of the thermal eye
        """

__all__ = ['ThermalFrame', 'ThermalEye', 'SimDualCamera']
