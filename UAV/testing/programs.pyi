"For tests: run MAVProxy and other programs in an environment of their own."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

def own_environment(name: str, *installs: str) -> Path:
    """A virtual environment in the system's folder for temporary files, made on first use

    Args:
        name: Of the environment, for example 'mavproxy'
        installs: What to tell `pip install`, one call each; words are split at blanks
    """
@contextmanager
def mavproxy(*options: str, modules: str = 'link', **popen: Any) -> Generator[Any, None, None]:
    """MAVProxy as long as the `with` lasts, in an environment and a folder of its own; gives its process

    Args:
        options: As in its command line, for example `--master=/dev/ttyUSB0`
        modules: What it loads at the start
        popen: For `subprocess.Popen`, for example `stdin=subprocess.PIPE`
    """

__all__ = ['own_environment', 'mavproxy']
