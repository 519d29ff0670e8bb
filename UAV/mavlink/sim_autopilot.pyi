"A simulated autopilot for a desk without an aircraft: it sends heartbeats, and tells how the vehicle is held and where it is."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.component import Component
from typing import Any

autopilots: dict

class SimAutopilot(Component):
    "An autopilot, as far as gimbals and ground stations need one"
    vehicle: Any
    gimbals: tuple
    rate: float
    def __init__(
            self, vehicle: Any, source_component: int = ..., mav_type: int = ..., autopilot: str = 'generic',
            armed: bool = False, rate: float = 10.0, gimbals: tuple = ..., loglevel: int = ...,
    ) -> None:
        """
        Args:
            vehicle: A `SimVehicle`, or any object with `state()`, which gives a `VehicleState`, and `origin`
            autopilot: Or 'px4' or 'ardupilot': what it pretends to be
            armed: Do the motors turn?
            rate: Of attitude and position, times a second; 0: only when asked for
            gimbals: Component ids of gimbal devices that are told how the vehicle is held, 50 times a second
        """
    def on_mav_connection(self) -> None: ...
    def arm(self, armed: bool = True) -> None:
        """Say in the heartbeat that the motors turn, or that they do not

        Args:
            armed: Do the motors turn?
        """
    def start_streams(self) -> None:
        "Start what an autopilot sends by itself: attitude and position at `rate`, home each second"

__all__ = ['autopilots', 'SimAutopilot']
