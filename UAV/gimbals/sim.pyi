"A gimbal without hardware: it takes its time, has limits, hangs below a vehicle that turns, and breaks when you want it to."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.gimbal import Gimbal
from UAV.gimbals.suspension import Suspension
from UAV.gimbals.values import GimbalAttitude, GimbalInformation, Setpoint, VehicleState
from collections import deque
from collections.abc import Generator
from typing import Any


class Steps:
    "Equal steps on a clock"
    most: float
    clock: Any
    dt: float
    began: Any
    count: Any
    def __init__(self, clock: Any, dt: float) -> None:
        """
        Args:
            clock: Gives seconds
            dt: s, one step
        """
    @property
    def time(self) -> float:
        "Now, s on the gimbal's clock"
    def due(self) -> Generator[Any, None, None]:
        "The time of each step since the last call"

class Delayed:
    "A value that changes some time after it was set"
    value: Any
    delay: float
    coming: deque
    def __init__(self, value: Any, delay: float = 0.0) -> None: ...
    def set(self, value: Any, t: float) -> None:
        "From `t` and the delay on"
    def at(self, t: float) -> Any:
        "What it is at `t`; `t` never goes back"

class SimGimbal(Gimbal):
    "A gimbal with three axes that is worked out when it is asked"
    breaks: dict
    mount: Any
    faults: dict
    stowed: list
    steps: Steps
    driven: Delayed
    suspension: Suspension
    fault: Any
    def __init__(
            self, vehicle: Any = None, model: str = 'SimGimbal', roll: tuple | None = ..., pitch: tuple | None = ...,
            yaw: tuple | None = ..., stowed: tuple = ..., delay: float = 0.0, locks: tuple = ..., clock: Any = ...,
            **motor: Any
    ) -> None:
        """
        Args:
            vehicle: The `SimVehicle` it hangs from; `None`: it hangs still, until `set_vehicle` tells it more
            model: As in `GimbalInformation`
            roll, pitch, yaw: Limits, degrees
            stowed: Roll, pitch and yaw when it is retracted, degrees
            delay: s from a setpoint until it counts
            locks: Axes that hold their direction on earth; the others lean with the vehicle
            clock: Gives seconds, and never goes back; with another one, call `tick` yourself
            motor: `smoothing` as for `Suspension`; `speed` and `acceleration` as for `Motor`
        """
    def in_effect(self, t: float) -> Setpoint:
        "What the motors are told at `t`"
    def advance(self) -> None:
        "Work out what has happened until now"
    def drive(self, setpoint: Setpoint) -> None:
        """Tell the motors; raises `GimbalError` when the cable is broken

        Args:
            setpoint: Where to point
        """
    @property
    def failures(self) -> tuple:
        "What is wrong, as GIMBAL_DEVICE_ERROR_FLAGS names it"
    def attitude(self) -> GimbalAttitude:
        "Where it points, at the end of the last step"
    @property
    def vehicle(self) -> VehicleState | None:
        "What is known of the vehicle; `None` when nothing is, or no longer"
    def set_vehicle(self, state: VehicleState) -> None:
        """Tell the gimbal what it hangs from; one that hangs from a `SimVehicle` knows better

        Args:
            state: How the vehicle is held, and where it is, now
        """
    def look(self) -> tuple:
        "North, east, height (m), roll, pitch, yaw (degrees, from north) of its camera, at one moment"
    def retract(self) -> None:
        "Fold away, and switch the motors off"
    def break_down(self, part: str, broken: bool = True) -> None:
        """Break a part: no motor turns, the cable is cut, the angles are not known, or one axis is stuck

        Args:
            part: 'motor', 'comms' or 'encoder', or the axis that gets stuck
            broken: False: it is mended
        """

__all__ = ['Steps', 'Delayed', 'SimGimbal']
