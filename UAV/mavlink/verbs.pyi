"Write a client's method for a command as one marked function that returns the command's parameters."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def verb(cmd: int) -> Any:
    """Mark a function that returns the parameters of `cmd`: it becomes a method that sends them, and returns the `Ack`

    Args:
        cmd: The MAV_CMD to send
    """
def sends(cmd: int) -> Any:
    """Mark a method as a verb that sends `cmd`, for `list_verbs`

    Args:
        cmd: A MAV_CMD
    """
def verbs(cls: Any) -> dict:
    "`{name: MAV_CMD}` of all marked verbs, by name"

__all__ = ['verb', 'sends', 'verbs']
