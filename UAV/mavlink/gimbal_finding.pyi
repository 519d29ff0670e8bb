"`find_gimbals` lists the gimbals on a link, and `wait_ready` waits until one is complete, or says what is missing."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import GimbalInformation
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class RemoteGimbal:
    "A gimbal that was found"
    system: int
    component: int
    gimbal_device_id: int
    information: GimbalInformation | None = ...
    manager_information: Any = ...
    @property
    def name(self) -> str:
        "Vendor and model"
    @property
    def can(self) -> tuple:
        "Names of its GIMBAL_MANAGER_CAP_FLAGS"
streamed: tuple
needed: tuple

__all__ = ['streamed', 'needed', 'RemoteGimbal']
