"Pack the messages of a component with its own address and sequence numbers, and send an ack before what the command brought about."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.protocol import Command
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from typing import Any
from typing_extensions import Self


class Sender:
    "Packs and sends the messages of one component, in order"
    component: Any
    mav: mavlink.MAVLink | Any
    def __init__(self, component: Any) -> None: ...
    def join(self, system: int, component: int) -> None:
        "Make the encoder that marks our messages with our ids"
    def send_now(self, msg: Any, to: tuple | None = None) -> None:
        """Send `msg`, also while others are held back

        Args:
            msg: As the encoder `mav` makes it
            to: `(system, component)` that gets it; `None`: as the message says
        """
    def ack_first(self, own_thread: bool = False) -> Hold:
        """For a `with`: hold back messages (not those of `send_now`) until its end

        Args:
            own_thread: Hold only what this thread sends
        """
    def send(self, msg: Any, to: tuple | None = None) -> Any:
        """Send `msg`, or hold it back; raises `LinkError` when we are on no link, `ValueError` when a field does not fit

        Args:
            msg: As the encoder `mav` makes it
            to: `(system, component)` that gets it; `None`: as the message says
        """

class Hold:
    "Messages that are held back while commands are handled; a `with` for each"
    sender: Sender
    key: Any
    depth: Any
    messages: list
    def __init__(self, sender: Sender, key: Any) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def release(self) -> None:
        "A command is done: send what was held, unless another command holds it still"
def encode_command(command: Command) -> Any:
    "`command` as a COMMAND_LONG, or as a COMMAND_INT when it has a `frame`; raises `ValueError` when it cannot be one"

__all__ = ['Sender', 'Hold', 'encode_command']
