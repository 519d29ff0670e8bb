"`Helm` turns a gimbal while you hold a button, stops it when you let go or vanish, and takes and gives back control."
# Written by .ci/stubs.py from the live classes: do not edit.
import asyncio
from UAV.manager.log import CommandLog, Entry
from UAV.mavlink.gimbal_client import GimbalClient
from collections import deque
from dataclasses import dataclass
from typing import Any


class Helm:
    "Moves one gimbal for the panel"
    what: str
    patience: float
    refresh: float
    most: float
    client: GimbalClient
    who: str
    changed: Any
    log: Any
    taken: bool
    held: Hold | Any
    ended: deque
    def __init__(self, client: GimbalClient, who: str = '', log: CommandLog | None = None, changed: Any = ...) -> None:
        """
        Args:
            client: With this gimbal as its target
            who: How the log calls it
            log: Gets a line for each time that a button was held
            changed: Called when something has changed that a viewer shows
        """
    async def seize(self, take_over: bool = False) -> None:
        """Be in control, as each move needs it; raises `Denied`, which says who is, and `MAVError`

        Args:
            take_over: Take it from another, too
        """
    @property
    def locked(self) -> bool:
        "Does the yaw stay where it is on earth?"
    async def hold(self, pitch: float, yaw: float, hold: str, n: int) -> None:
        """The button is held, still; raises `ValueError` once it was let go, and for the first word what `Ack.check` raises

        Args:
            pitch, yaw: Degrees a second
            hold: The same for as long as the button is down, and then never again
            n: Counts the words about it
        """
    async def rest(self, why: str = 'another button was pressed') -> None:
        """End what is held, and wait until the gimbal turns no more

        Args:
            why: For the log
        """
    async def release(self, hold: str) -> Any:
        """The button was let go; returns when the gimbal has said that it turns no more. Raises `MAVError` when it does not

        Args:
            hold: As for `hold`
        """
    async def give(self) -> None:
        "Turn no more, and give control back, if it is ours; raises what `Ack.check` raises"
    async def close(self, timeout: float = 5.0) -> None:
        """Turn no more, and give back the control that we took; raises `MAVError` when the gimbal does not say so in time

        Args:
            timeout: Seconds: without a link there is nothing to wait for
        """

@dataclass(repr=False)
class Hold:
    "A button that is held down"
    id: str
    rates: tuple
    entry: Entry
    n: int = ...
    until: float = ...
    why: str = ...
    error: Exception | None = ...
    sent: bool = ...
    begun: asyncio.Event = ...
    news: asyncio.Event = ...
    task: asyncio.Task | None = ...
    async def pause(self, seconds: float) -> None:
        "Wait so long, or until the rates change"
def hold_id(id: str) -> str:
    "`id`; raises `ValueError` for what a view would not make"

__all__ = ['Helm', 'Hold', 'hold_id']
