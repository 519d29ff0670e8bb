"Keep what is known of each other component: what it is, whether it is alive, and how long its answers take."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any

first_rto: float
least_rto: float
longest_back_off: float

class RoundTrip:
    "How long a question and its answer take, in seconds (RFC 6298)"
    srtt: float | Any
    rttvar: Any
    least: Any
    largest: Any
    rto: Any
    asked: int
    answers: bool
    def __init__(self) -> None: ...
    @property
    def deaf(self) -> bool:
        "Was it asked three times or more, and has never answered?"
    def sample(self, seconds: float) -> None:
        """Learn from one answer

        Args:
            seconds: From a question to its answer
        """
    def wait(self, copies: int = 1) -> float:
        """Seconds to wait for the answer until the next copy: the time-out, doubled each time

        Args:
            copies: How many are on the wire
        """

@dataclass
class Remote:
    "A component elsewhere; times are monotonic seconds"
    address: tuple
    type: int | None = ...
    autopilot: int = ...
    system_status: int = ...
    heard: float = ...
    alive: float = ...
    frames: int = ...
    lost: bool = ...
    sequences: dict = ...
    aheads: list = ...
    double: bool = ...
    round_trip: RoundTrip = ...
    @property
    def name(self) -> str:
        "`system/component`, and what it is"
    def note_step(self, came: list, sequence: int, frames: int, now: float) -> None:
        "`sequence` follows the numbers that `came`, and `frames` frames: is it too large or too small, and not just late?"
    @property
    def seems_double(self) -> bool:
        "Do the last ten numbers look like those of two components?"

class Remotes(dict):
    "`{(system, component): Remote}` of all that were heard, or have answered"
    lost_after: float
    most: int
    def known(self, address: tuple) -> Remote:
        "The `Remote` of `address`, which is made when it is new"
    def beat(self, address: tuple, msg: Any, now: float) -> bool:
        """Note a heartbeat; true when the component is new here, or back

        Args:
            address: `(system, component)` that sent it
            msg: Its HEARTBEAT
            now: Monotonic time, s
        """
    def silent(self, now: float, frames: Any = ...) -> list:
        """The remotes that are lost from now on

        Args:
            now: Monotonic time, s
            frames: How many frames of `(system, component)` have come by now
        """
    def why_lost(self, address: tuple) -> str:
        "Why `address` is lost, in words; empty when it is not"
    def note_sequence(
            self, address: tuple, sequence: int, link: Any = None, frames: int = 0, restarts: int = 0, now: float = 0.0,
    ) -> bool:
        """Note the number of a heartbeat; true once, when the numbers say that two components use this address

        Args:
            address: `(system, component)` that sent a HEARTBEAT
            sequence: The number of its frame, 0 … 255
            link: The link that brought it
            frames: How many frames of `address` had come on that link by then, doubled ones not counted
            restarts: How often its numbers had begun anew on that link
            now: Monotonic time, s
        """
late: int
latest: int
longest_late: float

__all__ = [
    'first_rto', 'least_rto', 'longest_back_off', 'late', 'latest', 'longest_late', 'RoundTrip', 'Remote', 'Remotes',
]
