"Start the `main` of a script: an error of this package, or Ctrl-C, ends it in one line."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Callable
from typing import Any

def run(main: Callable[..., Any]) -> None:
    """Do what a script does; an error of ours, or Ctrl-C, ends it in one line

    Args:
        main: Called with the words behind the script's name; a coroutine is awaited
    """

__all__ = ['run']
