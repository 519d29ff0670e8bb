"For tests: two serial ports of this machine and the cable between them, which you can pull."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any
from typing_extensions import Self


class Cable:
    "A serial cable with a port at each end; while one plug is out, what the other end sends is lost"
    names: Any
    def __init__(self, *names: str) -> None:
        """
        Args:
            names: Paths of the two ports; without them, they are in a temporary folder
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def plug_in(self, name: str) -> None:
        "The port `name` appears"
    def pull(self, name: str) -> None:
        "The port `name` is gone"
    def close(self) -> None:
        "Pull both plugs; no thread, no file and no port is left"

__all__ = ['Cable']
