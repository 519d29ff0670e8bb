"`LoopThread`: an asyncio loop that runs in a thread of its own, beside the loop of the notebook."
# Written by .ci/stubs.py from the live classes: do not edit.
import asyncio
from concurrent.futures import Future
from typing import Any
from typing_extensions import Self


class LoopThread:
    "An asyncio loop in a thread, until `close`"
    loop: Any
    def __init__(self, name: str = 'loop') -> None:
        """
        Args:
            name: Of the thread
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def inside(self) -> bool:
        "Are we called from this thread?"
    @property
    def closed(self) -> bool:
        "Has `close` been called?"
    def run(self, coro: Any) -> Future:
        """Start it there; raises `RuntimeError` when the loop is closed, or closes

        Args:
            coro: A coroutine
        """
    async def ask(self, coro: Any) -> Any:
        """Its result, for a caller on any loop

        Args:
            coro: A coroutine
        """
    @property
    def orphaned(self) -> bool:
        "Are we in a forked process? Its thread has stayed behind"
    def close(self, timeout: float = 5.0) -> Any:
        """Cancel what runs, and end the thread

        Args:
            timeout: Seconds until what does not end is left behind
        """
async def set_within(event: asyncio.Event, seconds: float) -> None:
    """Wait until `event` is set, which happens after so many seconds at the latest

    Args:
        event: Set by others, or by the timer
        seconds: To wait at most
    """

__all__ = ['LoopThread', 'set_within']
