"The panel without a screen: `Gui` knows the cameras and gimbals, does what you press, and tells how it went."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
import threading
from UAV.manager.log import Btn_State as Btn_State, CommandLog
from UAV.manager.news import News, Update
from UAV.manager.rows import Row, Row as Row, action as action
from UAV.manager.server import PanelServer
from UAV.utils.loop_thread import LoopThread
from collections.abc import Sequence
from typing import Any
from typing_extensions import Self


class ExitEvent(threading.Event):
    "Set when the panel is to end, from any thread"
    tell: Any
    def __init__(self, tell: Any) -> None:
        """
        Args:
            tell: Called when it is set
        """
    def set(self) -> None: ...

class Gui:
    "A control panel for cameras and gimbals"
    id: str
    kind: str
    lives: Sequence
    most_rows: int
    ask_again: Sequence
    forget_after: float
    camera_client: Any
    gimbal_client: Any
    title: str
    functions: dict
    rows: dict
    log: CommandLog
    hosts: list
    calling: set
    logger: logging.Logger
    exit_event: ExitEvent
    closed: bool
    loop: LoopThread
    news: News
    last_pictures: Any
    def __init__(
            self, camera_client: Any = None, gimbal_client: Any = None, auto: Any = None, reset: Any = None,
            pause: Any = None, title: str = 'UAV',
    ) -> None:
        """
        Args:
            camera_client: A `CameraClient` that is on a link
            gimbal_client: A `GimbalClient` that is on a link
            auto, reset, pause: Your functions, or coroutine functions: each gets a button
            title: Over the panel
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def wake(self) -> None:
        "A picture has come: viewers get it"
    def changed(self) -> None:
        "Something has changed: viewers get the status anew"
    def close(self) -> Any:
        "Stop what turns, give back what we took, end what shows it; may be called twice"
    @property
    def us(self) -> str:
        "`system/component` as which the panel speaks; empty when it is on no link"
    def buttons(self) -> dict:
        "`{name: state}` of the panel's own buttons"
    def status(self) -> dict:
        "All that a viewer shows, as plain values; what is unknown is `None`"
    def add_row(self, row: Row) -> Row:
        "Show a row; on the panel's loop"
    def show(self, row: Row) -> Row:
        "The same for other threads: the row is there when this returns"
    async def remove_row(self, id: str) -> None:
        "Show it no longer"
    def target_of(self, what: str, of: str | None = None) -> tuple:
        "`(row or panel, method)` of a button; `of=None`: the first one that has it. Raises `ValueError`"
    async def do(self, what: str, of: str | None = None, **args: Any) -> dict:
        """Press a button, from any event loop: `ok` and `text`. Raises `ValueError` or `TypeError` for one that is not there

        Args:
            what: Name of a button
            of: Id of a row; `None`: the first one that has this button
            args: What the button needs
        """
    async def poll(self, seen: str = '', after: dict | None = None, timeout: float = 1.0) -> Update:
        """What is newer than what a viewer has, from any event loop

        Args:
            seen: Tag of the status that the viewer has
            after: `{camera id: number of its last picture}` of the cameras that it shows; -1: it has none
            timeout: Seconds to wait for something new
        """
    async def next_picture(self, of: str | None = None, after: int = -1, timeout: float = 1.0) -> tuple | None:
        "`(number, JPEG)` of a picture later than `after`, if one comes in time; see `frame`. On the panel's loop"
    def frame(self, of: str | None = None, after: int = -1, timeout: float = 1.0) -> bytes | None:
        """The newest picture as a JPEG; `None` when none comes in time. Not for the panel's own loop

        Args:
            of: Id of a camera; `None`: the first one
            after: Number of the last picture seen
            timeout: Seconds to wait for a later one
        """
    async def auto(self) -> Any:
        "Call your function `auto`"
    async def reset(self) -> Any:
        "Call your function `reset`"
    async def pause(self) -> Any:
        "Call your function `pause`"
    async def exit(self) -> None:
        "End the panel: `exit_event` is set"
    async def until_exit(self) -> None:
        "Wait for `exit_event`, on any event loop"
    def card(self, timeout: float = 2.0) -> str:
        """What the panel shows, as HTML that needs nothing else, below 20 kB

        Args:
            timeout: Seconds to wait for cameras that have no picture yet
        """
    def row_of(self, kind: type, where: tuple) -> Row | None:
        """The row of a camera or gimbal, which is made when it is new; `None` when there are too many. On the panel's loop

        Args:
            kind: `CameraRow` or `GimbalRow`
            where: `(system, component)`, and for a gimbal its number
        """
    async def watch_cameras(self) -> None:
        "Give each camera that is heard a row, for as long as the panel lives"
    async def watch_gimbals(self) -> None:
        "Give each gimbal that a manager tells of a row, for as long as the panel lives"
    async def find_cameras(self, count: int | None = None, timeout: float = 1.5) -> list:
        """A row for each camera that beats, from any event loop; raises `LinkError`

        Args:
            count: Return as soon as so many have been heard
            timeout: Seconds to listen
        """
    async def find_gimbals(self, count: int | None = None, timeout: float = 1.5) -> list:
        """A row for each gimbal there is, from any event loop; raises `LinkError`

        Args:
            count: Return as soon as so many have been found
            timeout: Seconds to listen
        """
    async def forget_lost(self) -> None:
        "Take away the rows of what has been lost for long, for as long as the panel lives"
    async def gimbal_control(self) -> None:
        "Be in control of the gimbals that no other client has, until `exit_event`; from any event loop"
    def serve(self, port: int = 0, host: str = '127.0.0.1', token: str | None = None, names: tuple = ...) -> PanelServer:
        """Serve it to browsers; raises `OSError` (the port is taken), `ValueError` (a weak token), `RuntimeError` (closed)

        Args:
            port: TCP; 0: any that is free
            host: Where to listen; '': all addresses of this computer, for other computers, too
            token: `None`: a new one. Your own, so that open pages find a panel that starts anew
            names: Other names under which browsers know it, such as that of a proxy
        """
    async def run_gui(self, port: int = 0, host: str = '127.0.0.1', token: str | None = None) -> None:
        """Serve the panel to browsers until `exit_event`; raises `OSError` when the port is taken

        Args:
            port: TCP; 0: any that is free
            host: Where to listen; '': all addresses of this computer, for other computers, too
            token: `None`: a new one
        """

__all__ = ['ExitEvent', 'Gui', 'Btn_State', 'Row', 'action']
