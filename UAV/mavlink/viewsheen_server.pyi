"A Viewsheen gimbal camera on MAVLink: a gimbal that ground stations point, with a camera that zooms, shoots and follows."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.viewsheen import Viewsheen
from UAV.mavlink.gimbal_server import GimbalServer
from typing import Any


class GimbalServerViewsheen(GimbalServer):
    "Serves a Viewsheen gimbal camera as a MAVLink gimbal that takes the commands of a camera, too"
    def for_us(self, camera_id: int) -> None:
        "Raise `Denied` when a command names another camera: we are 0 (all), or our component id"
    def __init__(
            self, source_component: int = ..., mav_type: int = ..., gimbal: Viewsheen | None = None, loglevel: int = ...,
            host: str = '192.168.144.200', port: int = 2000, **kwargs: Any
    ) -> None:
        """
        Args:
            source_component: 154, 171 to 175 are what others look for
            gimbal: A driver; `None`: one for `host` and `port`
            host, port: Of the device
            kwargs: As in `ViewsheenSetup`, and as of a `GimbalServer`
        """
    def close(self) -> None:
        "Stop turning, and leave the link; a driver that was made here is closed"

__all__ = ['GimbalServerViewsheen']
