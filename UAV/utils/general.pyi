"The three clocks of MAVLink, one thread for all that happens again and again, and one for work that takes long."
# Written by .ci/stubs.py from the live classes: do not edit.
from logging import Logger
from typing import Any

log: Logger
def time_since_boot_ms() -> int:
    "Milliseconds since this process imported the package, as a uint32 that wraps after 49 days"
def time_UTC_usec() -> int:
    "Microseconds since the UNIX epoch, UTC"
def date_time_str() -> str:
    "Local date and time for a file name, such as `2026-11-21_09-30-00`"

class Job:
    "A function to call every `period` seconds, next at `due`"
    f: Any
    period: Any
    due: Any
    cancelled: bool
    def __init__(self, f: Any, period: Any, due: Any) -> None: ...
    def __lt__(self, other: Any) -> bool: ...
    def advance(self, now: Any) -> None:
        "Move on to the next whole period after `now`; what was missed is skipped, not caught up"

class Timers:
    "Calls functions at regular times from one thread, which lives as long as it has a job"
    name: str
    def __init__(self, name: str = 'timers') -> None: ...
    def every(self, period: float, f: Any, delay: float = 0.0) -> Job:
        """Call `f` every `period` seconds without drift, until `cancel`

        Args:
            period: Seconds between two calls
            f: Called without arguments; must be quick, all jobs share one thread
            delay: Seconds until the first call
        """
    def cancel(self, job: Job, timeout: float | None = None) -> bool:
        """Never call `job` again; false when a call is still under way

        Args:
            timeout: Seconds to wait for a call that is under way; `None`: until it ends
        """
    def alarm(self, f: Any) -> Job:
        "A job that calls `f` when `move` has set it, once each time"
    def move(self, job: Job, due: float) -> None:
        "Have `job` called at `due` (monotonic time), or when it rings before that"
timers: Timers

class Worker:
    "Calls functions one after the other, on a thread of its own"
    patience: float
    name: str
    def __init__(self, name: str) -> None: ...
    def do(self, f: Any, *args: Any) -> None:
        "Call `f(*args)` when all before it are done"
    def close(self, hurry: Any = None) -> None:
        """Do what waits, and end the thread; safe to call twice

        Args:
            hurry: Called when half of our patience is over and jobs are still under way
        """

__all__ = ['log', 'timers', 'time_since_boot_ms', 'time_UTC_usec', 'date_time_str', 'Job', 'Timers', 'Worker']
