"Each picture gets the place where it was taken and the direction of the camera, from the autopilot and the gimbal on the link."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.trail import AttitudeTrail, PositionTrail
from UAV.cameras.values import Pose
from UAV.mavlink.gimbal_vehicle import VehicleHeard
from UAV.utils.seen import Seen
from typing import Any


class Geotagger:
    "Where a camera was at any moment, and how it was held: from what its vehicle and its gimbal tell"
    remembers: float
    wrong: float
    takers: dict
    camera: Any
    clock: Any
    utc: Any
    positions: PositionTrail
    attitudes: AttitudeTrail
    gimbal: AttitudeTrail
    heard: VehicleHeard
    clocks: dict
    asked: Seen
    time_heard: Any
    autopilot: tuple | Any
    def __init__(self, camera: Any, clock: Any = ..., utc: Any = ...) -> None:
        """
        Args:
            camera: Its `gimbal_device_id`, `mounted` and `clock_error` are used, if it has them
            clock: Gives seconds
            utc: Gives seconds since 1970, as the camera dates its frames
        """
    def made(self, msg: Any) -> float:
        "When `msg` was made, s on our clock"
    def take_position(self, msg: Any) -> None:
        "GLOBAL_POSITION_INT; raises `ValueError`"
    def take_attitude(self, msg: Any) -> None:
        "ATTITUDE or AUTOPILOT_STATE_FOR_GIMBAL_DEVICE; raises `ValueError`"
    def velocity(self) -> tuple:
        "North, east and down, m/s, as told last; NaN when that is not known"
    def take_feedback(self, msg: Any) -> None:
        "CAMERA_FEEDBACK; raises `ValueError`"
    def take_gimbal(self, msg: Any) -> None:
        "GIMBAL_DEVICE_ATTITUDE_STATUS of the gimbal that turns the camera; raises `ValueError`"
    def take_time(self, msg: Any) -> None:
        "SYSTEM_TIME: how wrong is this computer's clock?"
    def to_ask(self, autopilot: tuple) -> list:
        "The messages to ask `autopilot` for now, each once in ten seconds"
    def take(self, msg: Any) -> None:
        "Note what a message tells; raises `ValueError` when that cannot be"
    def looks(self, t: float) -> tuple | None:
        "How the camera was held at `t`: a quaternion, or `None`"
    def moment(self, time_utc: float | None) -> float:
        "A time of the camera on our clock; long ago, when it cannot be"
    def pose(self, time_utc: float | None = None) -> Pose:
        """Where the camera was, and how it was held; what is unknown is NaN

        Args:
            time_utc: s since 1970, as the camera dates its frames; `None`: now
        """
    def listen_to(self, autopilot: tuple) -> None:
        "From now on `autopilot` tells where we are"
def lacks_pose(camera: Any) -> bool:
    "Has the camera no pose of its own, but for one that a server gave it?"

__all__ = ['Geotagger', 'lacks_pose']
