"For tests: the part that sends commands again, with a clock that stands still until you move it."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def ack_of(command_id: int, result: int, source: tuple) -> Any:
    """A COMMAND_ACK as it arrives

    Args:
        command_id: A MAV_CMD
        result: A MAV_RESULT
        source: `(system, component)` that sends it
    """
def desk(commands: Any) -> Any:
    """A class like `commands`, with a clock of its own; what it sends stands in `sent`

    Args:
        commands: The class of the machine, `Commands`
    """

__all__ = ['ack_of', 'desk']
