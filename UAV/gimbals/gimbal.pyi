"The base class of all gimbals. You write `information`, `drive` and `attitude`, and get angles, rates, lock, and a stop when the rates end."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
from UAV.gimbals.region import Location
from UAV.gimbals.values import Axis, GimbalAttitude, GimbalInformation, Setpoint, VehicleState
from collections.abc import Sequence
from typing import Any
from typing_extensions import Self


class Gimbal:
    "A gimbal; subclasses give `information`, `drive` and `attitude`, and `retract` when they can do that"
    information: GimbalInformation
    locks: Sequence
    follows: Sequence
    rate_lasts: float
    vehicle_lasts: float
    fault: Any
    clock: Any
    log: logging.Logger
    setpoint: Any
    closed: bool
    def __init__(self, clock: Any = ...) -> None:
        """
        Args:
            clock: Gives seconds, and never goes back; with another one, call `tick` yourself
        """
    def drive(self, setpoint: Setpoint) -> Any:
        "Tell the device; must be quick, and may raise `GimbalError`. A subclass has it"
    def attitude(self) -> GimbalAttitude:
        "Where it points now; must be quick. A subclass has it"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "Stop turning, and take no more setpoints; may be called twice"
    def set_vehicle(self, state: VehicleState) -> None:
        """Tell the gimbal what it hangs from; raises `ValueError` for an attitude that makes no sense

        Args:
            state: How the vehicle is held, and where it is, now
        """
    @property
    def vehicle(self) -> VehicleState | None:
        "What is known of the vehicle; `None` when nothing is, or no longer"
    @property
    def heading(self) -> float:
        "Where the vehicle's nose points, degrees from north; NaN when that is not known"
    @property
    def can_lock(self) -> bool:
        "Can its yaw hold a direction on earth?"
    def point(
            self, roll: Axis = ..., pitch: Axis = ..., yaw: Axis = ..., frame: str | None = None, lock: bool | None = None,
            lasts: float | None = None,
    ) -> None:
        """Take a new target for some axes, or all; raises `ValueError`, `HeadingUnknown` and `GimbalError`

        Args:
            roll, pitch, yaw: What is neither angle nor rate keeps what it had
            frame: What `yaw` is measured from: 'vehicle' or 'earth'; `None`: 'earth' when locked
            lock: Does yaw hold its direction on earth? `None`: as it was
            lasts: s until rates end; `None`: `rate_lasts`
        """
    def set_angles(
            self, pitch: float = ..., yaw: float = ..., roll: float = ..., frame: str = 'vehicle',
            lock: bool | None = None,
    ) -> None:
        """Point there

        Args:
            pitch, yaw, roll: Degrees; NaN keeps
            frame: What `yaw` is measured from: 'vehicle' or 'earth'
            lock: Does yaw hold its direction on earth? `None`: as it was
        """
    def set_rates(
            self, pitch: float = 0.0, yaw: float = 0.0, roll: float = ..., lock: bool | None = None,
            lasts: float | None = None,
    ) -> None:
        """Turn, until the rates are given again, or end

        Args:
            pitch, yaw, roll: Degrees a second; NaN keeps
            lock: Does yaw hold its direction on earth? `None`: as it was
            lasts: s until they end; `None`: `rate_lasts`
        """
    def center(self) -> None:
        "Look straight ahead"
    def lock(self) -> None:
        "Hold the direction on earth; raises `HeadingUnknown`"
    def follow(self) -> None:
        "Let yaw follow the vehicle's nose"
    def stop(self) -> None:
        "Turn no more, and hold; what is not turning stays as it is. A device that does not hear it is told again"
    def tick(self) -> None:
        "End rates that are over"
    def look_at(self, location: Location, state: VehicleState | None = None) -> None:
        """Point at a place, once; raises `PositionUnknown`, `HeadingUnknown` and what `drive` raises

        Args:
            location: Where to look
            state: Where the vehicle is; `None`: as the gimbal was told
        """

__all__ = ['Gimbal']
