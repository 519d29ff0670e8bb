"The panel in a cell, over the notebook's own connection: it works wherever the notebook does."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.gui import Gui
from typing import Any


class Messages:
    "Answers what a view asks by messages"
    gui: Gui
    send: Any
    def __init__(self, gui: Gui, send: Any) -> None:
        """
        Args:
            gui: The panel
            send: Called with an answer and a list of pictures, in the panel's thread
        """
    async def poll(self, seen: str = '', after: dict | None = None) -> tuple:
        "What is newer than what the view has, see `Gui.poll`"
    async def act(self, do: str, of: str | None = None, args: dict | None = None) -> tuple:
        "Press a button, see `Gui.do`"
    async def thumbnail(self, of: str, key: int) -> tuple:
        "A small picture of one that was taken; raises `ValueError` when it is not there"
    async def answer(self, message: dict) -> None:
        """Send the answer to `message`; what is wrong is told as `error`

        Args:
            message: From the view
        """
    def take(self, message: dict) -> None:
        """Have `message` answered on the panel's loop; from any thread

        Args:
            message: From the view
        """

class WidgetView:
    "One live view of a panel in a notebook; raises `ImportError` without anywidget"
    widget: Any
    messages: Messages
    def __init__(self, gui: Gui) -> None:
        """
        Args:
            gui: The panel
        """
    def close(self) -> None:
        "The view goes"

__all__ = ['Messages', 'WidgetView']
