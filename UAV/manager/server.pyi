"`gui.serve()` gives an address, which you open in a browser, on this computer or through a tunnel."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.gui import Gui
from UAV.manager.site import Site
from UAV.utils.sockets import Loop
from typing import Any
from typing_extensions import Self


class PanelServer:
    "Serves the panel to browsers; `with` closes it"
    most: int
    gui: Gui
    host: str
    run: Any
    site: Site
    visits: set
    closed: bool
    listener: Any
    port: Any
    loop: Loop
    def __init__(
            self, gui: Gui, port: int = 0, host: str = '127.0.0.1', token: str | None = None, names: tuple = ...,
    ) -> None:
        """
        Args:
            gui: The panel
            port: TCP; 0: any that is free
            host: Where to listen; '': all addresses of this computer, for other computers, too
            token: `None`: a new one. Your own, so that open pages find a panel that starts anew
            names: Other names under which browsers know it, such as that of a proxy
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def link(self, host: str) -> str:
        """The address of the page, with its token

        Args:
            host: Name or address of this computer, as the browser can reach it
        """
    @property
    def url(self) -> str:
        "The address of the page for a browser on this computer"
    def close(self, patience: float = 1.0) -> None:
        """End all connections, and give the port back; may be called twice

        Args:
            patience: s for answers that are under way
        """

__all__ = ['PanelServer']
