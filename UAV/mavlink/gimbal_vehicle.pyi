"Learn from an autopilot's messages how the vehicle is held and where it is, and for how long that is true."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import VehicleState
from typing import Any

POSITION: int
ATTITUDE: int
GIMBAL_STATE: int
HOME: int
def told_by(msg: Any) -> dict:
    """What it says, by the fields of a `VehicleState`; raises `ValueError` when that cannot be

    Args:
        msg: One of these three
    """

class VehicleHeard:
    "What was heard of one vehicle"
    lasts: dict
    clock: Any
    home_alt: Any
    def __init__(self, clock: Any = ...) -> None: ...
    def take(self, msg: Any) -> None:
        "Note what `msg` says; raises `ValueError` when that cannot be"
    def age(self, msg_id: Any) -> float:
        "s since this message came; infinite when it never did"
    def fresh(self, *msg_ids: Any) -> bool:
        "Has one of these messages come lately?"
    @property
    def missing(self) -> list:
        "The messages without which attitude or position are not known now"
    def to_ask(self, autopilot: tuple) -> list:
        "The messages to ask `autopilot` for now: those that are missing, each once in ten seconds"
    @property
    def state(self) -> VehicleState:
        "All that is known now, and not too old"

__all__ = ['POSITION', 'ATTITUDE', 'GIMBAL_STATE', 'HOME', 'told_by', 'VehicleHeard']
