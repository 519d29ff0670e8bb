"Take pictures and get exactly those, also on a bad link: each shot is verified, and asked for again when it was not taken."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.camera_client import CameraClient
from UAV.mavlink.picture_log import PictureLog
from typing import Any


class Capture:
    "Pictures that were asked for, until each of them has been given"
    tries: int
    stopped: bool
    patience: int
    client: CameraClient
    target: tuple
    interval: float
    timeout: float
    owed: Any
    log: PictureLog
    number: Any
    running: bool
    asked: int
    given: Any
    since: Any
    def __init__(self, client: CameraClient, target: tuple, interval: float, count: int, timeout: float) -> None: ...
    @property
    def name(self) -> str:
        "Address and kind of the camera"
    async def next(self) -> Any:
        "The next CAMERA_IMAGE_CAPTURED; `None` after the last. Raises `CommandError`, `Lost` or `NoAnswer`"
    async def end(self) -> None:
        "Have the camera stop our series; again when it does not answer, or begins after that"

__all__ = ['Capture']
