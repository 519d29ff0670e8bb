"Choose whether a gimbal server is manager, device or both, its number, and what else the gimbal protocol leaves open."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.handlers import Tables
from dataclasses import dataclass
from typing import Any

managers: tuple
devices: tuple

class RoleTables(Tables):
    "The marked methods of a component, without those of other roles, or that need an option which is off"
    role: str
    def __init__(self, component: Any, role: str) -> None: ...
    def ours(self, roles: Any = ..., needs: Any = None, **options: Any) -> bool:
        "Is a method with these options in its mark ours?"
    def find(self, kind: Any) -> dict:
        "The marked methods of one kind, without those of another role"

@dataclass
class GimbalOptions:
    "How a `GimbalServer` reads the gimbal protocol where it leaves a choice"
    strict: bool = ...
    px4_release: bool = ...
    roi_long_alt: str = ...
    mount_control: bool = ...
    yaw_frame: str = ...
    attitude_rate: float = ...
    status_rate: float = ...
    command_lasts: float = ...
    stream_lasts: float = ...
    max_rate: float = ...
    ask_autopilot: bool = ...
def checked_device_id(number: int | None, component: int, role: str) -> int:
    """The number of the device; raises `ValueError` when ground stations would not find it

    Args:
        number: What the manager calls the device; `None`: what fits the role
        component: Our component id
    """

__all__ = ['managers', 'devices', 'RoleTables', 'GimbalOptions', 'checked_device_id']
