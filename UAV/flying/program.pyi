"Open the links that the options name, show the panel on a page, and tell how it is until Ctrl-C."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.serving.status import Teller
from collections.abc import Generator
from contextlib import ExitStack, contextmanager
from types import SimpleNamespace
from typing import Any

inner: str
def wanted_links(typed: Any) -> list:
    "Connection strings of the panel; raises `ValueError`"
def own_token(typed: str | None) -> str | None:
    """The token to use; `None`: a new one. Raises `ValueError` for one that is too short, or not for an address

    Args:
        typed: `None`: what `UAV_GUI_TOKEN` says
    """
@contextmanager
def ground(connections: list, system: int, component: int, key: bytes | None = None) -> Generator[Any, None, None]:
    """For a `with`: a client for cameras and one for gimbals, on these links

    Args:
        connections: Connection strings
        system: System id of the panel
        component: Component id of its client for gimbals
        key: Of signed links
    """
def served(gui: Any, port: int, host: str, token: str | None) -> Any:
    """Its page; raises `OSError` when there is no place for it

    Args:
        gui: A `Gui`
        port, host, token: As for `Gui.serve`
    """
def understood(typed: Any) -> SimpleNamespace:
    """The options as values; raises `ValueError`, or `OSError` for a key that cannot be read

    Args:
        typed: Has the options of `fly` as attributes
    """
def opened(typed: Any, stack: ExitStack) -> tuple:
    """Open what was typed: `(Gui, its server)`; raises `ValueError`, `MAVError` or `OSError`

    Args:
        typed: Has the options of `fly` as attributes
        stack: Closes what was opened
    """
def present(status: dict) -> dict:
    """`{id: what it is and how}` of cameras and gimbals

    Args:
        status: As from `Gui.status`
    """
def news_of(now: dict, last: dict) -> list:
    """A line for each that came, changed or went

    Args:
        now: As from `present`
        last: The same, a moment ago
    """
def introduce(gui: Any, server: Any, teller: Teller) -> None:
    "Tell where the page is, and what the panel listens to"
def follow(gui: Any, teller: Teller, period: float = 1.0) -> None:
    "Tell what is news, until the panel is to end"
def show(url: str, teller: Teller) -> None:
    "Open a page in the user's browser, and say so when there is none"
def end_as_with_ctrl_c() -> None:
    "Signals that end a program raise `KeyboardInterrupt`; those that are ignored stay so"
def run(typed: Any, teller: Teller) -> None:
    "Open what was typed, and tell what is news until the panel is to end"
def fly(
        connection: str | None = None, sim: bool = False, path: str | None = None, browser: bool = False,
        port: int = 0, host: str = '127.0.0.1', token: str | None = None, sign: str | None = None, system: int = 253,
        component: int = ...,
) -> None:
    """A control panel for cameras and gimbals, as a page for your browser, until Ctrl-C. Examples:

    Args:
        connection: MAVLink links, with commas between them; without it: udpin:0.0.0.0:14550
        sim: Fly a simulated vehicle, with a camera on a gimbal
        path: What that vehicle flies: hover or circle
        browser: Open the page in your browser
        port: Of the page; 0: a free one
        host: Where the page is served: this machine only; 0.0.0.0: all that reach it may try
        token: For the address of the page, also from UAV_GUI_TOKEN; without it: a new one each time
        sign: File with the key of a signed link
        system: System id of the panel
        component: Component id of the panel
    """

__all__ = [
    'inner', 'wanted_links', 'own_token', 'ground', 'served', 'understood', 'opened', 'present', 'news_of',
    'introduce', 'follow', 'show', 'end_as_with_ctrl_c', 'run', 'fly',
]
