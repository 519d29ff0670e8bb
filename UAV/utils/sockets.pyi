"`Loop` waits for all sockets of a server on one thread, and `listen_tcp` opens a port."
# Written by .ci/stubs.py from the live classes: do not edit.
from logging import Logger
from typing import Any
from typing_extensions import Self

log: Logger

class Loop:
    "One thread that waits for many sockets; `with` closes it"
    name: str
    tick: Any
    def __init__(self, name: str, tick: Any = ...) -> None:
        """
        Args:
            name: Of the thread
            tick: Called at least once a second, on the thread
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def call(self, do: Any) -> None:
        """Let the loop's thread call `do()`, soon

        Args:
            do: A function without parameters
        """
    def close(self) -> None:
        "End the thread; the sockets that were watched stay open"
    def ask(self, do: Any) -> Any:
        """Let the loop's thread call `do()`, and wait until it has; there, call it at once

        Args:
            do: A function without parameters
        """
    def watch(self, sock: Any, ready: Any, write: bool = False) -> None:
        """Wait for this socket from now on

        Args:
            sock: A socket that does not block
            ready: Called with the events, when it has something for us
            write: Also when it takes something from us?
        """
    def forget(self, sock: Any) -> None:
        """Wait for it no more; call this before you close it

        Args:
            sock: One that is watched; others are ignored
        """
    def serve(self, listener: Any, welcome: Any) -> None:
        """Welcome all who connect, from now on

        Args:
            listener: From `listen_tcp`
            welcome: Called with the socket and the address of each newcomer, on the loop's thread
        """
def listen_tcp(host: str = '', port: int = 0) -> Any:
    """Listen for connections; raises `OSError`

    Args:
        host: Our own address or name; empty: all that we have
        port: 0: any that is free
    """

__all__ = ['log', 'Loop', 'listen_tcp']
