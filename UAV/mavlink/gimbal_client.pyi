"Find out where a gimbal points and who is in control of it, and send it commands."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import GimbalAttitude
from UAV.logging import LogLevels as LogLevels
from UAV.mavlink.component import Component
from UAV.mavlink.gimbal_at import GimbalAt
from UAV.mavlink.gimbal_finding import RemoteGimbal
from UAV.mavlink.protocol import Expectations
from UAV.utils.values import Value
from UAV.wire.dialect import Ack
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from typing import Any
from typing_extensions import Self

GIMBAL_DEVICE_ATTITUDE_STATUS: int
GIMBAL_DEVICE_INFORMATION: int
GIMBAL_MANAGER_INFORMATION: int
GIMBAL_MANAGER_STATUS: int
def device_address(system: int, component: int, gimbal_device_id: int) -> tuple:
    """`(system, component, gimbal_device_id)` of a gimbal device, with 0 for a component of its own

    Args:
        system, component: That sent the message
        gimbal_device_id: As in the message
    """

class GimbalClient(Component):
    "Finds and commands MAVLink gimbals"
    most_gimbals: int
    refresh: float
    gimbal_device_id: int
    heard: dict
    news: Expectations
    headings: dict
    asked: dict
    turned: dict
    holds: dict
    def __init__(self, source_component: int, mav_type: int = ..., loglevel: int = ...) -> None:
        """
        Args:
            source_component: Our component id, for example `MAV_COMP_ID_MISSIONPLANNER` (190)
        """
    def set_target(self, target_system: int, target_component: int, gimbal_device_id: int = 0) -> None:
        """Which gimbal our verbs are for

        Args:
            gimbal_device_id: As the manager says; 0: all it has
        """
    def lose(self, source: tuple, why: str) -> None:
        "As every component does; and those who wait for news of `source` end, too"
    def farewell(self) -> None:
        "Stop what we turn; the `MAVCom` calls this while it still has a link"
    def close(self) -> None:
        "Stop what we turn, and leave the link; those who wait for news end, too"
    def on_gimbal_message(self, msg: Any) -> None:
        "Keep what is told of a gimbal"
    def least(self, gimbal: tuple) -> tuple:
        "`(system, component, gimbal_device_id)`; id 0 becomes the least one of its manager that was heard, if any was"
    def newest(self, msg_id: int, gimbal: tuple) -> Any:
        "The newest message of a kind about `(system, component, gimbal_device_id)`; `None`: none came"
    async def ask_gimbal(self, source: tuple, msg_id: int, fits: Any = ..., command_id: int = ..., *more: Any) -> Any:
        "A message of `source`, or `None`; `command_id` with parameters `msg_id` and `more` asks for it"
    @property
    def gimbal(self) -> tuple:
        "Our target, `(system, component, gimbal_device_id)`; id 0 becomes the least that was heard. Raises `MAVError`"
    def on_attitude(self, msg: Any) -> None:
        "Keep where a vehicle points"
    def heading_of(self, system: int) -> float:
        "Where the nose of a vehicle points, degrees from north; NaN when it has not told for a second"
    def where(self, gimbal: tuple) -> GimbalAttitude | None:
        "Where `(system, component, gimbal_device_id)` points; `None` when it has not told, or is lost"
    @property
    def attitude(self) -> GimbalAttitude | None:
        "Where our gimbal points; `None` when it has not told, or is lost"
    def attitudes(self) -> AsyncGenerator[Any, None]:
        "For `async for`: where our gimbal points, each time it tells; not what it tells while you work. Raises `Lost`"
    def status_of(self, gimbal: tuple) -> GimbalStatus | None:
        "Who is in control of `(system, component, gimbal_device_id)`; `None` when that was not heard"
    @property
    def status(self) -> GimbalStatus | None:
        "Who is in control of our gimbal; `None` when that was not heard"
    @property
    def us(self) -> tuple:
        "`(system, component)` of this client"
    @property
    def in_control(self) -> bool:
        "Does the manager of our gimbal say that it is ours?"
    def held_by_other(self, gimbal: tuple) -> bool:
        "Does its manager say that another is in control of a gimbal?"
    async def gimbal_command(self, gimbal: tuple, command_id: int, params: Any, frame: int | None = None) -> GimbalAck:
        """Send a command that may safely be done twice to a gimbal's manager

        Args:
            gimbal: `(system, component, gimbal_device_id)`
            command_id: A MAV_CMD
            params: Up to seven numbers
            frame: A MAV_FRAME makes it a COMMAND_INT
        """
    async def remote_gimbal(self, gimbal: tuple) -> RemoteGimbal:
        "What is known of `(system, component, gimbal_device_id)`; its device is asked what it is, if it has not said so"
    async def find_gimbals(self, count: int | None = None, timeout: float = 1.5) -> list[RemoteGimbal]:
        """A `RemoteGimbal` for each gimbal there is, ordered by address; raises `LinkError` when we are on no link

        Args:
            count: Return as soon as so many have been found
            timeout: Seconds to listen; heartbeats come once a second
        """
    def who_beats(self) -> str:
        "The other components that are there, as text"
    async def any_gimbals(self, timeout: float = 5.0) -> list[RemoteGimbal]:
        """As `find_gimbals`; where there is none at first, it waits for one

        Args:
            timeout: Seconds until one must have been heard
        """
    async def choose(self, timeout: float = 5.0) -> RemoteGimbal:
        """Make the only gimbal there is our target; raises `NoAnswer` when there is none, `MAVError` when there are several

        Args:
            timeout: Seconds until one must have been heard
        """
    async def wait_ready(self, timeout: float = 5.0) -> RemoteGimbal:
        """Wait until our gimbal is complete; without a target, take the only one. `NoAnswer` says what is missing

        Args:
            timeout: Seconds
        """
    async def give_back(self, gimbal: tuple) -> GimbalAck:
        "Let go of `(system, component, gimbal_device_id)`, if it is ours"
    @asynccontextmanager
    def control(self, take_over: bool = False, keep: bool = False) -> AsyncGenerator[Any, None]:
        """For `async with`, also inside itself: be in control of our gimbal. Raises `Denied` when another is, and `NoAnswer`

        Args:
            take_over: Take it from another, too
            keep: Stay in control at the end
        """
    def at(self, system: int, component: int, gimbal_device_id: int = 0) -> GimbalAt:
        """The same client with another target: for several gimbals at once

        Args:
            system, component: The gimbal's manager
            gimbal_device_id: As the manager says; 0: all it has
        """
    async def set_zoom(self, value: float, camera: tuple | None = None) -> Ack:
        """Zoom the camera

        Args:
            value: %: 0 is wide, 100 is as near as it can
            camera: `(system, component)`; `None`: the gimbal itself
        """
    async def start_capture(self, interval: float = 0.0, count: int = 1, camera: tuple | None = None) -> Ack:
        """Take pictures

        Args:
            interval: Seconds between two pictures
            count: How many; 0: until `stop_capture`
            camera: `(system, component)`; `None`: the gimbal itself
        """
    async def stop_capture(self, camera: tuple | None = None) -> Ack:
        """Take no more pictures

        Args:
            camera: `(system, component)`; `None`: the gimbal itself
        """
    async def set_angles(
            self, pitch: float = ..., yaw: float = ..., frame: str = 'vehicle', lock: bool | None = None,
            pitch_rate: float = ..., yaw_rate: float = ...,
    ) -> Ack:
        """Point there; raises `HeadingUnknown` when an autopilot is the manager, and yaw must be turned for it

        Args:
            pitch, yaw: Degrees; NaN leaves it as it is
            frame: What `yaw` is measured from: 'vehicle' or 'earth'
            lock: Does yaw hold its direction on earth? `None`: one from north does
            pitch_rate, yaw_rate: How fast to go there, degrees a second; NaN: as it likes
        """
    async def reached(self, timeout: float = 10.0, tolerance: float = 1.0) -> GimbalAttitude | None:
        """Wait until our gimbal points where it was told; its attitude, `None` when it is not there in time. Raises `Lost`

        Args:
            timeout: Seconds
            tolerance: Degrees
        """
    async def set_attitude(
            self, pitch: float = ..., yaw: float = ..., pitchspeed: float = ..., yawspeed: float = ...,
    ) -> Ack:
        """Point there

        Args:
            pitch, yaw: Degrees, yaw from the nose
            pitchspeed, yawspeed: Degrees a second; NaN: as it likes
        """
    async def center(self) -> Ack:
        "Look straight ahead"
    async def retract(self) -> Ack:
        "Fold away; the motors may be off then"
    async def lock(self) -> Ack:
        "Hold the direction on earth, however the vehicle turns"
    async def follow(self) -> Ack:
        "Let yaw follow the vehicle's nose"
    async def set_rates(self, pitch: float = 0.0, yaw: float = 0.0, lock: bool | None = None) -> Ack:
        """Turn; most gimbals stop after three seconds, unless they are told again

        Args:
            pitch, yaw: Degrees a second
            lock: Does yaw hold its direction on earth? `None`: as it is
        """
    def send_rates(self, gimbal: tuple, pitch: float, yaw: float, lock: bool) -> None:
        """Send GIMBAL_MANAGER_SET_ATTITUDE with rates: it has no ack, and a gimbal that is not ours ignores it

        Args:
            pitch, yaw: Degrees a second
            lock: Does yaw hold its direction on earth?
        """
    @asynccontextmanager
    def keep_turning(self, pitch: float = 0.0, yaw: float = 0.0, lock: bool | None = None) -> AsyncGenerator[Any, None]:
        """For `async with`: turn until its end. Raises what `Ack.check` raises, and at the end `Denied` if another took over

        Args:
            pitch, yaw: Degrees a second
            lock: Does yaw hold its direction on earth? `None`: as it is
        """
    async def point_at(self, lat: float, lon: float, alt: float, alt_frame: str = 'amsl') -> Ack:
        """Look at a place until told otherwise; raises `ValueError`

        Args:
            lat, lon: Degrees
            alt: m
            alt_frame: Above the sea ('amsl'), or above where the vehicle took off ('relative')
        """
    async def point_at_none(self) -> Ack:
        "Look at the place no longer"
    async def follow_system(self, sysid: int) -> Ack:
        """Look at another vehicle, wherever it goes

        Args:
            sysid: Its system id
        """
of_manager: tuple
of_device: tuple
def about(msg: Any) -> tuple:
    "The gimbal that a manager's `msg` is about, or the address of the device that sent it"
request: int

@dataclass(frozen=True, repr=False, eq=False)
class GimbalStatus(Value):
    "What a GIMBAL_MANAGER_STATUS says"
    primary: tuple | None = ...
    secondary: tuple | None = ...
    flags: int = ...
not_in_control: int

class GimbalAck(Ack):
    "An `Ack` of a gimbal's manager; when it refuses because another is in control, it prints that"
    status: GimbalStatus | None
    def __new__(cls, ack: Ack, status: GimbalStatus | None = None) -> Self:
        """
        Args:
            ack: As `send_command` gave it
            status: Who is in control; `None`: that is not why
        """
    @property
    def reason(self) -> str:
        "Who is in control, or what the dialect says about `result`"

__all__ = [
    'of_manager', 'of_device', 'request', 'not_in_control', 'device_address', 'GimbalClient', 'about', 'GimbalStatus',
    'GimbalAck', 'GIMBAL_DEVICE_ATTITUDE_STATUS', 'GIMBAL_DEVICE_INFORMATION', 'GIMBAL_MANAGER_INFORMATION',
    'GIMBAL_MANAGER_STATUS', 'LogLevels', 'mavlink',
]
