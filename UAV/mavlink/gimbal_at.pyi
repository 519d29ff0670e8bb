"`client.at(…)` is the same client with another target: one component on the link, and a handle for each gimbal."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.gimbal_client import GimbalClient
from typing import Any


class GimbalAt(GimbalClient):
    "One gimbal of a client, which has no target but that"
    client: GimbalClient
    def __init__(self, client: GimbalClient, system: int, component: int, gimbal_device_id: int = 0) -> None:
        """
        Args:
            client: As which it speaks
            system, component: The gimbal's manager
            gimbal_device_id: As the manager says; 0: all it has
        """
    def __getattr__(self, name: Any) -> Any: ...
    def farewell(self) -> None:
        "Stop what we turn of this gimbal"
    def close(self) -> None:
        "Stop what we turn of this gimbal; the client stays on its link"

__all__ = ['GimbalAt']
