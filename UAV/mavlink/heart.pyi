"Send the heartbeats of all components of a system with one timer, greet newcomers, and notice which components have fallen silent."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.remotes import Remotes
from UAV.utils.seen import Seen
from typing import Any


class Heart:
    "Beats for the components of one system, and knows who else is there"
    com: Any
    period: float
    lost_after: float
    stuck_after: float
    remotes: Remotes
    sent: Seen
    stuck: Any
    greeted: Any
    job: Any
    def __init__(self, com: Any, period: float = 1.0, lost_after: float = 5.0, stuck_after: float = 2.0) -> None:
        """
        Args:
            com: The system: its `component`, `channels` and `log`
            period: s between two heartbeats
            lost_after: s of silence after which a component is lost
            stuck_after: s after which a handler that does not return silences us: no command is answered either
        """
    def start(self) -> None:
        "Beat from now on, every `period` seconds"
    def stop(self) -> None:
        "Beat no more"
    def tick(self) -> None:
        "What the timer does"
    def beat(self) -> None:
        "Have every component send its heartbeat"
    def check_stuck(self) -> bool:
        "Has a handler held up a reader for `stuck_after` seconds?"
    def note(self, msg: Any, source: tuple, ours: bool = False) -> None:
        """Remember who has beaten, and greet newcomers

        Args:
            msg: A HEARTBEAT
            source: `(system, component)` that sent it
            ours: A component of this system did
        """
    def frames(self, address: tuple) -> int:
        "How many frames of `address` have come, on all links"
    def lost(self, address: tuple) -> str:
        "Why `address` is lost; empty when it is not, or when a frame of it has come since we looked"
    def watch(self) -> None:
        "Look who has fallen silent, and who is back"
    def lose(self, source: tuple) -> None:
        "`source` has fallen silent"
    def check_double(self, msg: Any, source: tuple) -> None:
        "Do the numbers of its frames say that two components use the address `source`?"
    def check_echo(self, msg: Any, source: tuple) -> None:
        "A frame with our own address came: an echo, or another one that uses it"
def essence(frame: bytes) -> bytes:
    "Number, address and payload of a MAVLink 2 frame: the same with and without a signature"

__all__ = ['Heart', 'essence']
