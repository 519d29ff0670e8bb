"The panel calls a function of yours in a thread of its own, and goes on if the function hangs, fails or exits."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def as_error(e: BaseException) -> Exception:
    """`e`, or in its place an error that ends neither a thread nor a loop

    Args:
        e: That a function has raised
    """
async def in_thread(f: Any, name: str = 'call') -> Any:
    """What `f` returns, called in a thread of its own; raises what it raises, as `as_error`

    Args:
        f: Function without parameters
        name: Of the thread
    """
async def call(f: Any, name: str = 'call') -> Any:
    """What comes of it; a coroutine runs on the loop of the caller

    Args:
        f: Function or coroutine function
        name: Of the thread of a function
    """

__all__ = ['as_error', 'in_thread', 'call']
