"Turn the bits and radians of the gimbal protocol into words and degrees, and back."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import Axis, GimbalAttitude, GimbalInformation
from UAV.utils.values import Value
from dataclasses import dataclass
from typing import Any

RETRACT: int
NEUTRAL: int
ROLL_LOCK: int
PITCH_LOCK: int
YAW_LOCK: int
VEHICLE_FRAME: int
EARTH_FRAME: int
ACCEPTS_EARTH: int
RC: int
LEVEL: int
def yaw_frame(flags: int) -> str:
    """What the yaw beside these flags is measured from: 'vehicle' or 'earth'; raises `ValueError` when they say both

    Args:
        flags: GIMBAL_DEVICE_FLAGS or GIMBAL_MANAGER_FLAGS: the values are the same
    """

@dataclass(frozen=True, repr=False, eq=False)
class Target(Value):
    "What a sender wants of a gimbal; what was not given is NaN"
    roll: Axis = ...
    pitch: Axis = ...
    yaw: Axis = ...
    frame: str = ...
    lock: bool = ...
    mode: str = ...
most_angle: float
most_rate: float
def axis_target(what: str, angle: float = ..., rate: float = ...) -> Axis:
    """What is wanted of one axis; raises `ValueError`

    Args:
        what: One of `axes`
        angle: Degrees
        rate: Degrees a second
    """
def flags_target(flags: int, roll: Axis = ..., pitch: Axis = ..., yaw: Axis = ...) -> Target:
    """What flags and axes together want; raises `ValueError`, or `Unsupported` for a radio control

    Args:
        flags: GIMBAL_DEVICE_FLAGS or GIMBAL_MANAGER_FLAGS
    """
def pitchyaw_target(
        flags: int, pitch: float = ..., yaw: float = ..., pitch_rate: float = ..., yaw_rate: float = ...,
) -> Target:
    "What DO_GIMBAL_MANAGER_PITCHYAW and its kin want, degrees and degrees a second; raises `ValueError`, `Unsupported`"
def attitude_target(flags: int, q: tuple, rates: tuple) -> Target:
    """What a SET_ATTITUDE wants; raises `ValueError`, `Unsupported`

    Args:
        q: (w, x, y, z), or four NaN
        rates: Roll, pitch and yaw, rad/s; NaN where there is none
    """
def axis_limits(information: GimbalInformation, axis: str) -> tuple:
    """Least and greatest angle, degrees: half a turn at most, and 0 without such an axis

    Args:
        axis: One of `axes`
    """
def stick_axis(
        information: GimbalInformation, axis: str, angle: float = ..., rate: float = ..., most: float = 30.0,
) -> Axis:
    """What a stick wants of one axis; raises `ValueError`

    Args:
        axis: One of `axes`
        angle: -1 to 1: all the way down or left, to all the way up or right
        rate: -1 to 1
        most: Degrees a second of a full rate
    """
def stick_target(flags: int, pitch: Axis, yaw: Axis) -> Target:
    "What GIMBAL_MANAGER_SET_MANUAL_CONTROL wants; raises `ValueError`, `Unsupported`"
def flag_names(enum: str, flags: int) -> tuple:
    """The dialect's names of the bits in `flags`

    Args:
        enum: Such as 'GIMBAL_DEVICE_CAP_FLAGS'
    """
def capabilities(gimbal: Any) -> int:
    """GIMBAL_DEVICE_CAP_FLAGS

    Args:
        gimbal: A `Gimbal`, or any object with `information` and some of its verbs
    """
def limits(information: GimbalInformation) -> list:
    "Least and greatest roll, pitch and yaw, rad"
def packed(version: tuple) -> int:
    """A version as one number

    Args:
        version: major, minor, patch, dev
    """
def unpacked(version: int) -> tuple:
    "(major, minor, patch, dev)"
def caps(msg: Any) -> int:
    "All the capability bits of a GIMBAL_DEVICE_INFORMATION or a GIMBAL_MANAGER_INFORMATION"
def information_of(msg: Any) -> GimbalInformation:
    "What a GIMBAL_DEVICE_INFORMATION says"
def failure_flags(names: tuple) -> int:
    """GIMBAL_DEVICE_ERROR_FLAGS

    Args:
        names: Such as 'AT_PITCH_LIMIT'
    """
modes: dict
def report_flags(mode: str, lock: bool, frame: str = 'vehicle') -> int:
    """The flags of a report

    Args:
        mode: As in `Setpoint`
        lock: Does yaw hold its direction on earth?
        frame: What the yaw beside them is measured from
    """
def attitude_fields(a: GimbalAttitude, frame: str = 'vehicle') -> dict:
    """The fields of GIMBAL_DEVICE_ATTITUDE_STATUS from its flags on, but for the gimbal_device_id

    Args:
        frame: What its yaw is to be measured from; the vehicle when the heading is not known
    """
def checked_attitude(a: GimbalAttitude) -> GimbalAttitude:
    "`a`; raises what Python raises when no message can carry it"
def attitude_of(msg: Any, heading: float = ..., time: float = ...) -> GimbalAttitude:
    """What a GIMBAL_DEVICE_ATTITUDE_STATUS says; raises `ValueError` when it has two frames

    Args:
        msg: GIMBAL_DEVICE_ATTITUDE_STATUS
        heading: Where the vehicle's nose points, degrees, when the message does not say it
        time: When it came, s
    """
results: dict

__all__ = [
    'RETRACT', 'NEUTRAL', 'ROLL_LOCK', 'PITCH_LOCK', 'YAW_LOCK', 'VEHICLE_FRAME', 'EARTH_FRAME', 'ACCEPTS_EARTH', 'RC',
    'LEVEL', 'most_angle', 'most_rate', 'modes', 'results', 'yaw_frame', 'Target', 'axis_target', 'flags_target',
    'pitchyaw_target', 'attitude_target', 'axis_limits', 'stick_axis', 'stick_target', 'flag_names', 'capabilities',
    'limits', 'packed', 'unpacked', 'caps', 'information_of', 'failure_flags', 'report_flags', 'attitude_fields',
    'checked_attitude', 'attitude_of',
]
