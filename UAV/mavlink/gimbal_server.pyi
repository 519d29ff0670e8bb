"Put any gimbal object on MAVLink, as gimbal manager, as gimbal device, or as both."
# Written by .ci/stubs.py from the live classes: do not edit.
import threading
from UAV.gimbals.region import Location, RegionOfInterest
from UAV.gimbals.values import GimbalAttitude, GimbalInformation, VehicleState
from UAV.mavlink.gimbal_control import Control
from UAV.mavlink.gimbal_flags import Target
from UAV.mavlink.gimbal_options import GimbalOptions, RoleTables
from UAV.mavlink.gimbal_vehicle import VehicleHeard
from UAV.mavlink.health import DeviceServer, Health
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

GIMBAL_MANAGER_INFORMATION: int
GIMBAL_MANAGER_STATUS: int
GIMBAL_DEVICE_INFORMATION: int
GIMBAL_DEVICE_ATTITUDE_STATUS: int

class FakeGimbal:
    "A gimbal that can only say what it would be"
    information: GimbalInformation
    locks: Sequence
    follows: Sequence
    def attitude(self) -> GimbalAttitude:
        "Nothing is known"
def checked_gimbal(gimbal: Any) -> Any:
    "`gimbal`, or one that only describes itself; raises `TypeError`"

@dataclass
class SetpointStream:
    "What is remembered of streamed setpoints"
    waiting: tuple | None = ...
    done: tuple = ...
    took: float = ...
    dropped: int = ...
    retracted: float = ...
    lock: threading.Lock = ...

class GimbalServer(DeviceServer):
    "Serves a gimbal object as a MAVLink gimbal"
    results: dict
    with_each_tick: list
    tick_period: float
    asked_rates: dict
    mover: tuple | None | Any
    paced_by: dict
    quick: float
    retract_lasts: float
    gimbal: Any
    options: GimbalOptions
    tables: RoleTables
    gimbal_device_id: int
    health: Health
    control: Control
    heard: VehicleHeard
    neighbours: dict
    region: RegionOfInterest
    stream: SetpointStream
    def __init__(
            self, source_component: int = ..., mav_type: int = ..., gimbal: Any = None, loglevel: int = ...,
            gimbal_device_id: int | None = None, role: str = 'both', *, strict: bool = ..., px4_release: bool = ...,
            roi_long_alt: str = ..., mount_control: bool = ..., yaw_frame: str = ..., attitude_rate: float = ...,
            status_rate: float = ..., command_lasts: float = ..., stream_lasts: float = ..., max_rate: float = ...,
            ask_autopilot: bool = ...,
    ) -> None:
        """
        Args:
            source_component: 154, 171 to 175 are what others look for
            gimbal: A `Gimbal`, or any object with `information` and some of its verbs
            gimbal_device_id: What we call the device; `None`: 1, or a component that fits the role
            role: 'both', 'manager' or 'device'
            kwargs: As in `GimbalOptions`
        """
    @property
    def role(self) -> Any:
        "'both', 'manager' or 'device'"
    def on_mav_connection(self) -> None: ...
    def close(self) -> None:
        "Stop turning, and leave the link; the gimbal stays open"
    def is_ours(self, device_id: float) -> bool:
        "Does this number mean our gimbal? 0 and NaN mean all"
    def check_device(self, device_id: float) -> None:
        "Raise `Denied` when a command names another gimbal"
    def on_command(self, msg: Any) -> None:
        "As every component does, but a broadcast to another gimbal is not for us"
    def check_control(self, msg: Any) -> None:
        "Raise `Denied` when the sender of `msg` may not move the gimbal"
    def complain(self, about: str, error: Exception) -> None:
        "Log an error, once a minute for what it is `about`"
    def tick(self) -> None:
        "What is done ten times a second"
    def stop_turning(self) -> None:
        "Have the gimbal turn no more; never raises"
    @property
    def device_id(self) -> int:
        "The number in the messages of the device: 0 means its component, 1 to 6 one behind it"
    def attitude_now(self) -> GimbalAttitude:
        "Where the gimbal points; nothing but COMMS_ERROR when it does not say, or what makes no sense"
    @property
    def default_streams(self) -> dict:
        "What goes to all unasked: `{message id: µs}`"
    def start_streams(self) -> None:
        "Begin to send what goes out unasked"
    def tell_status(self) -> None:
        "Send GIMBAL_MANAGER_STATUS to all when it has changed"
    @property
    def vehicle(self) -> VehicleState:
        "What is known of the vehicle: from what we hear, else from what the gimbal knows"
    @property
    def our_autopilot(self) -> tuple | None:
        "`(system, component)` of the autopilot of our system; `None` when we hear none"
    def ask_autopilot(self) -> None:
        "Ask the autopilot of our system for what it does not send: MAV_CMD_SET_MESSAGE_INTERVAL"
    def is_there(self, source: tuple) -> bool:
        "Is `source` there, and the way to it, as far as we know?"
    def lasting(self, lasts: float | None, source: tuple | None) -> float | None:
        "s that rates of `source` last which it wants to last for `lasts`"
    def apply(
            self, target: Target, lasts: float | None = None, source: tuple | None = None, streamed: bool = False,
    ) -> None:
        """Have the gimbal do what `target` wants; raises `Unsupported`, and what the gimbal raises

        Args:
            lasts: s until rates end; `None`: as the gimbal likes
            source: `(system, component)` that wants it
            streamed: No command: it does not overtake what waits
        """
    def lose(self, source: tuple, why: str) -> None:
        "As every component does; and one that is silent controls nothing"
    def let_go(self, source: tuple, why: str) -> None:
        "`source` controls nothing any more, and what it turned stops"
    def set_pace(self, msg_id: int, interval: float, asker: tuple | None = None) -> None:
        """Send a message to all every `interval`

        Args:
            msg_id: One of `usual`
            interval: µs; -1: not at all
            asker: Who wants it; `None`: the usual rate
        """
    @property
    def vehicle_now(self) -> VehicleState:
        "Where our vehicle is now: from what we heard, else from what the gimbal knows"
    def neighbour_location(self, system: int, seconds: float = 0.0) -> Location:
        """Where another vehicle will be; raises `PositionUnknown`

        Args:
            system: Its system id
            seconds: From now
        """
    def look_at_roi(self) -> None:
        "Look again, and say when we cannot any more"
    def track(self, target: Any, msg: Any, device_id: float = 0) -> None:
        """Look at `target`, if the sender of `msg` may say so; raises `Denied`, `Unsupported`, and what the gimbal raises

        Args:
            target: A `Location`, or a function that gives one
            msg: The command
            device_id: For which gimbal
        """

__all__ = [
    'FakeGimbal', 'checked_gimbal', 'SetpointStream', 'GimbalServer', 'GIMBAL_MANAGER_INFORMATION',
    'GIMBAL_MANAGER_STATUS', 'GIMBAL_DEVICE_INFORMATION', 'GIMBAL_DEVICE_ATTITUDE_STATUS',
]
