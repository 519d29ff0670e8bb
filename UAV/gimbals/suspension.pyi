"Work out the attitude of a camera from that of its vehicle and the angles of three motors."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import GimbalInformation, Setpoint, VehicleState
from typing import Any


class Suspension:
    "Three motors between a vehicle and its camera"
    locks: tuple
    smoothing: float
    motors: dict
    grip: dict
    rates: Any
    vehicle: VehicleState
    ahead: Any
    ahead_rate: float
    q: Any
    def __init__(self, information: GimbalInformation, locks: tuple = ..., smoothing: float = 0.3, **motor: Any) -> None:
        """
        Args:
            information: Has the limits
            locks: Axes that hold their direction on earth; the others lean with the vehicle
            smoothing: s over which the nose is smoothed; 0: not at all
            motor: As for `Motor`
        """
    @property
    def angles(self) -> tuple:
        "Where the motors stand, degrees"
    def hang(self, vehicle: VehicleState) -> None:
        "Put it below `vehicle`, as it is turned"
    def lean(self) -> tuple:
        "What is left of the vehicle's roll and pitch: a quaternion in the direction of the camera, and the picture's roll"
    def attitude(self) -> tuple:
        "How the camera is held, `(w, x, y, z)`; yaw from the nose"
    def hold(self, power: bool, dt: float) -> None:
        """Grip or let go, within half a second

        Args:
            power: Have the motors power?
            dt: s
        """
    def smooth(self, dt: float) -> None:
        "Let `ahead` come after the nose"
    def zero(self, lock: bool) -> float:
        "Where yaw is measured from, degrees from the nose"
    def carry(self, vehicle: VehicleState, lock: bool, dt: float) -> None:
        """The vehicle moves on, and the zero of yaw with it

        Args:
            vehicle: How the vehicle is held now; what is not known stays as it was
            lock: Does yaw hold its direction on earth?
            dt: s since the last time
        """
    def step(self, setpoint: Setpoint, vehicle: VehicleState, dt: float, power: bool = True) -> None:
        """What happens in `dt`

        Args:
            setpoint: Where to point
            vehicle: How the vehicle is held now
            dt: s
            power: Have the motors power?
        """

__all__ = ['Suspension']
