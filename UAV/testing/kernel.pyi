"For tests: run cells in a Jupyter kernel without a browser, and hear all that they show."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any
from typing_extensions import Self


class Kernel:
    "A Jupyter kernel; ends with the `with`"
    manager: Any
    client: Any
    def __init__(self, python: str = ...) -> None:
        """
        Args:
            python: The Python that runs it; it needs ipykernel
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "It ends at once"
    def start(self, code: str) -> Any:
        """Begin to run a cell

        Args:
            code: Of the cell
        """
    def hear(self, until: Any, timeout: float = 60.0) -> list:
        """`(type, content)` of the messages that the kernel shows, up to the last one; raises `RuntimeError` for an error

        Args:
            until: Gets a message, and is true for the last one
            timeout: Seconds to wait for each message
        """
    def run(self, code: str) -> list:
        """Run a cell, and hear what it shows

        Args:
            code: Of the cell
        """
    def send(self, comm_id: str, message: dict) -> None:
        """Send a custom message to a widget

        Args:
            comm_id: Of the widget
            message: What its half in the browser says
        """
def told(heard: list) -> list:
    """The custom messages of widgets

    Args:
        heard: From `hear`
    """
def kernel_environment(name: str, *installs: str) -> Path:
    """An environment that has what we have, and `installs` in our stead

    Args:
        name: Of the environment
        installs: What to tell `pip install`, see `own_environment`
    """

__all__ = ['Kernel', 'told', 'kernel_environment']
