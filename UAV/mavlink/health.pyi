"Say in the heartbeat whether the device behind a component works, and send texts to the people at the ground stations."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.component import Component
from typing import Any

def pieces_of(text: str) -> list:
    "`text` in pieces of 50 bytes; the last one is not full, which says that it is the last"

class Health:
    "Watches the `fault` of a device, and tells of it in the heartbeat of a component"
    component: Component
    device: Any
    fault: Any
    def __init__(self, component: Component, device: Any) -> None:
        """
        Args:
            device: Has `information.model`; and a `fault`, when it can have one
        """
    @property
    def now(self) -> Any:
        "What is wrong with the device; a `fault` that cannot be read is one"
    @property
    def is_news(self) -> bool:
        "Has a fault come or gone since we looked?"
    def look(self) -> tuple | None:
        "Set the heartbeat's status: `(MAV_SEVERITY, text)` when there is news"
    def beat(self) -> None:
        "The component's heartbeat, which tells the truth about the device, and what is new"

class DeviceServer(Component):
    "A component that stands for a device; a subclass sets `health`, which knows the device"
    def can(self, verb: str) -> bool:
        """Has the device this verb?

        Args:
            verb: The name of a method
        """
    def need(self, verb: str) -> Any:
        """The device's verb; raises `Unsupported` when it has none

        Args:
            verb: The name of a method
        """
    def beat(self) -> None:
        "Our heartbeat, which says how the device is"

__all__ = ['pieces_of', 'Health', 'DeviceServer']
