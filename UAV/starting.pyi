"A program loads what it needs where Ctrl-C may come, and its options are the parameters of a function."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

@contextmanager
def until_ctrl_c() -> Generator[Any, None, None]:
    "Ctrl-C in the `with` ends the process with 130"
def run_with_options(f: Any, name: str) -> None:
    """Call `f` with the options that were typed; `--help` and mistakes end the process

    Args:
        f: Its parameters are the options
        name: Of the program, as it is typed
    """

__all__ = ['until_ctrl_c', 'run_with_options']
