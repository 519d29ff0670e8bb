"A simulated Viewsheen device on a TCP port, which behaves as its document says, and misbehaves when you ask it to."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.viewsheen_device import ViewsheenDevice
from typing import Any
from typing_extensions import Self


class DirectLine:
    "From a `Viewsheen` to a `ViewsheenDevice` in the same process, instead of a `TCPClient`"
    up: bool
    error: str | Any
    hear: Any
    changed: Any
    device: Any
    def __init__(self, device: Any) -> None: ...
    def start(self) -> Any:
        "Do nothing: it is connected"
    def close(self) -> None:
        "End the connection"
    def drop(self, why: Any) -> None:
        "End the connection, for a reason"
    def send(self, frame: Any) -> Any:
        "Is it on its way?"

class ViewsheenSimulator:
    "A Viewsheen gimbal camera, behind a TCP port; `with` closes it"
    report_period: float
    split: bool
    stalled: bool
    device: ViewsheenDevice
    feedback: bool
    host: str
    port: Any
    clients: dict
    def __init__(
            self, host: str = '127.0.0.1', port: int = 0, feedback: bool = False, *, clock: Any = ..., fed: bool = ...,
            zoom: float = ...,
    ) -> None:
        """
        Args:
            host, port: 0: any that is free
            feedback: Does it report how it is held?
        """
    def listen(self) -> None:
        "Let clients come"
    @property
    def skipped(self) -> Any:
        "Bytes that were no commands"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def wait(self, true: Any, timeout: float = 10.0) -> bool:
        """Wait until something is so, for example until a command was heard

        Args:
            true: A function of the simulator
            timeout: s
        """
    def send(self, data: bytes) -> None:
        """Send these bytes to all clients

        Args:
            data: Anything
        """
    def tell(self) -> None:
        "Report how it is held, when it reports at all"
    def drop(self) -> None:
        "Close all connections"
    def refuse(self) -> None:
        "Refuse all who come, and drop those who are here"
    def close(self) -> None:
        "Close the port and all connections; may be called twice"

__all__ = ['DirectLine', 'ViewsheenSimulator']
