"Drive a Viewsheen gimbal camera over TCP as any other gimbal, also after its cable was out."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.gimbal import Gimbal
from UAV.gimbals.values import GimbalAttitude, GimbalInformation, Setpoint
from UAV.gimbals.viewsheen_camera import Series
from UAV.utils.tcp_client import TCPClient
from UAV.utils.values import Value
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False, eq=False)
class ViewsheenSetup(Value):
    "A model of Viewsheen's, and how it is wired; the defaults are a UAP8003K alone"
    model: str = ...
    yaw_reference: str = ...
    byte4: int | None = ...
    feedback: bool = ...
    pitch: tuple = ...
    yaw: tuple = ...
    speeds: tuple = ...
    zoom: float = ...
    focal_length: float = ...
    @property
    def information(self) -> GimbalInformation:
        "What servers tell of it"
    @property
    def frame_byte(self) -> int:
        "The fourth byte of a yaw frame"

@dataclass
class Move:
    "What the device is to do, from when it was asked for"
    began: float = ...
    starts: dict = ...
    waits: bool = ...
    sent: bool = ...

class Viewsheen(Gimbal):
    "A Viewsheen gimbal camera, over TCP"
    locks: Sequence
    follows: Sequence
    rate_pace: float
    angle_pace: float
    fresh: float
    silence: float
    with_each_tick: list
    series: Series | Any
    least_interval: float
    setup: ViewsheenSetup
    axes: dict
    reports: dict
    line: Any
    setpoint: Setpoint
    def __init__(
            self, host: str = '192.168.144.200', port: int = 2000, clock: Any = ..., line: Any = None, *, model: str = ...,
            yaw_reference: str = ..., byte4: int | None = None, feedback: bool = ..., pitch: tuple = ..., yaw: tuple = ...,
            speeds: tuple = ..., zoom: float = ..., focal_length: float = ...,
    ) -> None:
        """
        Args:
            host, port: The factory's address is 192.168.42.200
            clock: Gives seconds; with another one, call `tick` yourself
            line: In tests, instead of a `TCPClient`
        """
    def close(self) -> None:
        "Stop turning, and hang up; may be called twice"
    @property
    def fault(self) -> str | None:
        "What is wrong with the device; `None`: it works"
    def attitude(self) -> GimbalAttitude:
        "Where it points now, by its reports and by what it was told"
    def drive(self, setpoint: Setpoint) -> None:
        "Begin to move; raises `HeadingUnknown`, and `ValueError` for roll, which it cannot"
    def tick(self) -> None:
        "Go on with what takes time, and end rates that are over"
    def set_camera_zoom(self, kind: str, value: float) -> None:
        """Zoom (CAMERA_ZOOM_TYPE); raises `ValueError` and `GimbalError`

        Args:
            kind: 'step', 'continuous', 'range' or 'focal_length'
            value: Steps, -1 to 1, % or mm
        """
    def set_camera_focus(self, kind: str, value: float = 0.0) -> None:
        """Focus (SET_FOCUS_TYPE); raises `ValueError` and `GimbalError`

        Args:
            kind: 'continuous', or 'auto', 'auto_single', 'auto_continuous'
            value: -1 to 1; positive is further away
        """
    def image_start_capture(self, interval: float = 0.0, count: int = 1) -> Any:
        """Take pictures; raises `ValueError` and `GimbalError`

        Args:
            interval: s between pictures; what is shorter than `least_interval` becomes that
            count: 0 until stopped
        """
    def image_stop_capture(self) -> None:
        "Take no more pictures; raises `GimbalError`"
    def take_series(self, now: float) -> bool:
        "Take the picture that is due; is there another one to come?"
    def video_start_capture(self, stream_id: int = 0) -> None:
        "Record; raises `GimbalError`"
    def video_stop_capture(self, stream_id: int = 0) -> None:
        "Record no more; raises `GimbalError`"
    def track_rectangle(self, left: float, top: float, right: float, bottom: float) -> None:
        """Follow what is in this box; raises `ValueError` and `GimbalError`

        Args:
            left, top, right, bottom: 0 to 1, from the left and from the top
        """
    def track_point(self, x: float, y: float, radius: float = 0.0) -> None:
        """Follow what is here; raises `ValueError` and `GimbalError`

        Args:
            x, y: 0 to 1, from the left and from the top
            radius: Of the width; 0: a box that fits most things
        """
    def stop_tracking(self) -> None:
        "Follow nothing; raises `GimbalError`"
    def tap_zoom(self, x: float, y: float) -> None:
        """Look to this point of the picture, and zoom in ×2; raises `ValueError` and `GimbalError`

        Args:
            x, y: 0 to 1, from the left and from the top
        """

__all__ = ['ViewsheenSetup', 'Move', 'Viewsheen']
