"Open the gimbal that you name, `--gimbal sim` or `--gimbal viewsheen://HOST`, and what it hangs from."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.gimbal import Gimbal
from UAV.gimbals.vehicle import SimVehicle
from UAV.mavlink.sim_autopilot import SimAutopilot
from typing import Any
from typing_extensions import Self

paths: dict
def make_vehicle(path: str) -> SimVehicle:
    """A simulated vehicle 30 m above the ground; raises `ValueError`

    Args:
        path: 'hover' or 'circle'
    """
def make_gimbal(text: str, vehicle: SimVehicle | None = None) -> Gimbal:
    """The gimbal that `text` means, which may not be there yet; raises `ValueError`

    Args:
        text: 'sim' or 'viewsheen://HOST[:PORT]'
        vehicle: What a simulated one hangs from; `None`: what MAVLink tells of the vehicle
    """

class Aboard:
    "What there is beside the camera: a vehicle, a gimbal and an autopilot, or some of them"
    vehicle: SimVehicle | Any
    gimbal: Gimbal | Any
    server: Any
    pilot: SimAutopilot | Any
    mount: Any
    def __init__(
            self, gimbal: str | None = None, path: str | None = None, autopilot: bool = False, camera: str = 'sim',
            role: str = 'both',
    ) -> None:
        """
        Args:
            gimbal: As for `make_gimbal`; `None`: there is none
            path: As for `make_vehicle`; `None`: it hovers, if it is needed
            autopilot: Does a simulated autopilot tell of the vehicle?
            camera: As for `make_camera`
            role: Of the gimbal's server: 'both', or 'device' when an autopilot manages it
        """
    @property
    def components(self) -> Any:
        "What goes on MAVLink"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "Let go of the gimbal"

__all__ = ['paths', 'make_vehicle', 'make_gimbal', 'Aboard']
