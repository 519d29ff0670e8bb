"Send a command again until its ack comes, and identical commands one after the other."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.protocol import Command
from UAV.mavlink.remotes import Remotes, RoundTrip
from UAV.utils.seen import Seen
from typing import Any

in_progress_timeout: float
longest_work: float

class Line:
    "Commands with one key: the first is on the wire, the others wait"
    def __init__(self, key: tuple, round_trip: RoundTrip) -> None: ...
    @property
    def is_unmeasured(self) -> bool:
        "Is nothing known of its round trip, which a question could tell?"

class Commands:
    "All commands of one component that are under way"
    remotes: Remotes
    clock: Any
    pings: Seen
    def __init__(self, remotes: Remotes, send: Any, ask: Any, alarm: Any = ..., clock: Any = ...) -> None:
        """
        Args:
            remotes: What is known of the components elsewhere
            send: Called with a `Command`: put a copy of it on the wire
            ask: Called with `(target, number)`: send a TIMESYNC and a PING with this number
            alarm: Called with the time at which `tick` must be called
            clock: Gives seconds
        """
    def start(self, command: Command) -> None:
        "Send `command`, or let it wait behind an identical one"
    def offer(self, ack: Any) -> bool:
        """Give an ack to the command that it answers; false when there is none

        Args:
            ack: A COMMAND_ACK for us
        """
    def tick(self) -> None:
        "Do what is due; called when the alarm rings, and at any other time"
    def drop(self, command: Command) -> None:
        "The answer of `command` is not needed any more"
    def lose(self, target: tuple | None, error: Exception) -> None:
        """End all commands to `target` with an error

        Args:
            target: `(system, component)`; `None`: all
            error: What the coroutines get
        """
    def answered(self, number: int, source: tuple) -> bool:
        """A TIMESYNC or PING of ours was answered; false when no fence waits for it

        Args:
            number: What `ask` was called with
            source: `(system, component)` that answers
        """
noise: float
longest_stray: float

__all__ = ['in_progress_timeout', 'longest_work', 'noise', 'longest_stray', 'Line', 'Commands']
