"`gui` at the end of a cell shows a live panel where a kernel can serve it, and a card everywhere else."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.gui import Gui
from typing import Any


class FrameView:
    "The panel's page in a frame of the notebook"
    server: Any
    widget: Any
    def __init__(self, gui: Gui, height: int = 640) -> None:
        """
        Args:
            gui: The panel
            height: Pixels
        """
    def close(self) -> Any:
        "The server stays: it is the panel's"

class Shown:
    "One display of a panel in a notebook; `close` puts its card there"
    gui: Gui
    view: Any
    id: Any
    def __init__(self, gui: Gui) -> None:
        """
        Args:
            gui: The panel
        """
    def close(self) -> None:
        "The view goes, and the card comes"

__all__ = ['FrameView', 'Shown']
