"Who is in control of a gimbal: one client at a time, who takes control and gives it back by one command."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

no_owner: tuple

class Control:
    "Who is in control of a gimbal"
    strict: bool
    px4_release: bool
    primary: Any
    secondary: Any
    def __init__(self, strict: bool = False, px4_release: bool = False) -> None:
        """
        Args:
            strict: Deny what comes while no client is in control? By default it is accepted then
            px4_release: Is "put me in control" from the one who is in control its release? PX4 sends that
        """
    @property
    def owner(self) -> str:
        "Who is in control, in words"
    def configure(self, sender: tuple, p1: float = -1, p2: float = -1, p3: float = -1, p4: float = -1) -> bool:
        """Do what MAV_CMD_DO_GIMBAL_MANAGER_CONFIGURE says; has it changed anything? Raises `Denied`

        Args:
            sender: `(system, component)` that asks
            p1, p2: Primary system and component
            p3, p4: Secondary system and component
        """
    def allows(self, sender: tuple) -> bool:
        "May `sender` move the gimbal now?"
    def lose(self, address: tuple) -> bool:
        "`address` has fallen silent, and controls nothing any more; did it?"
def changed_pair(pair: tuple, sender: tuple, system: float, component: float) -> tuple:
    """The new pair; raises `Denied` when it would be half a pair

    Args:
        pair: `(system, component)` that is in control
        sender: Who wants to change it
        system, component: What it wants
    """

__all__ = ['no_owner', 'Control', 'changed_pair']
