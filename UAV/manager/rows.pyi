"Give the panel a new button by marking a method; a row has all that the panel shows and does for one camera or gimbal."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def action(name: str, quiet: bool = False) -> Any:
    """Mark a coroutine method as something a viewer may do

    Args:
        name: Of the button
        quiet: Not in the log: it comes many times a second
    """
def actions(cls: type) -> dict:
    "`{name: method}` of all marked methods"
def on_or_off(on: Any) -> bool:
    """`on`; raises `ValueError` unless it is true or false

    Args:
        on: As a viewer has sent it
    """

class Row:
    "What the panel shows and does for one camera or gimbal; subclasses fill it"
    kind: str
    gui: Any
    id: str
    task: Any
    def __init__(self, gui: Any, id: str) -> None:
        """
        Args:
            gui: The `Gui`
            id: Such as '1/100'
        """
    def status(self) -> dict:
        "What a page shows of it: its id, and its buttons"
    async def run(self) -> Any:
        "Keep it up to date, until cancelled"
    async def close(self) -> Any:
        "Leave everything as it should be"
    async def picture(self, after: int) -> tuple | None:
        "`(number, JPEG)` of a picture later than `after`, if there is one"
    def buttons(self) -> dict:
        "`{name: state}` of its buttons"

__all__ = ['action', 'actions', 'on_or_off', 'Row']
