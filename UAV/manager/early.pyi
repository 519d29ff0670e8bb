"Buttons in a notebook work while a cell waits, also in ipykernel 6, which reads no messages before a cell has ended."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def this_kernel() -> Any:
    "The kernel that runs this; `None` when there is none"
def hear_early(comm_id: str, hear: Any) -> bool:
    """In ipykernel 6, call `hear` as soon as a custom message comes, also while a cell runs

    Args:
        comm_id: Of a widget
        hear: Gets each custom message, and must be quick
    """
def forget_early(comm_id: str) -> None:
    "Messages for this widget go their usual way again"

__all__ = ['this_kernel', 'hear_early', 'forget_early']
