"IPython shows a coroutine as a memory address. Ours show that nothing was done, and what to write."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import AsyncGenerator
from typing import Any

def name_unawaited(coroutine: Any, printer: Any, cycle: bool) -> None:
    """Print it for IPython

    Args:
        coroutine: What a cell ends with
        printer: IPython's
        cycle: Is it inside of itself? Never
    """

class Uniterated(AsyncGenerator):
    "What an async generator function of ours gives: for an `async for`"
    generator: Any
    def __init__(self, generator: Any) -> None:
        """
        Args:
            generator: What does the work
        """
    def __aiter__(self) -> Any: ...
    def asend(self, value: Any) -> Any: ...
    def athrow(self, *error: Any) -> Any: ...
    def aclose(self) -> Any: ...
    def __iter__(self) -> Any: ...
    def __await__(self) -> Any: ...
def for_async(f: Any) -> Any:
    """Mark `f`: a `for` without `async` is told so

    Args:
        f: An async generator function
    """
def show_unawaited() -> None:
    "Have IPython, if it runs, use `name_unawaited` from now on"

__all__ = ['name_unawaited', 'Uniterated', 'for_async', 'show_unawaited']
