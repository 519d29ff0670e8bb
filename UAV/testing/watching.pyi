"For tests: read what was logged without having it on the page, and let time run faster."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
from UAV.mavlink.mavcom import MAVCom
from typing import Any
from typing_extensions import Self


class Logged(logging.Handler):
    "What a logger says until `close`, or while the `with` lasts: kept, and not shown"
    logger: Any
    records: list
    def __init__(self, logger: str | logging.Logger = 'UAV', level: int = ...) -> None:
        """
        Args:
            logger: And all below it
            level: Lesser records are dropped
        """
    def close(self) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def emit(self, record: Any) -> None:
        "Keep a record; `logging` calls this"
    def lines(self, name: str = '') -> list:
        """The messages so far

        Args:
            name: Of one logger; empty is all
        """
    def until(self, words: str, name: str = '', timeout: float = 30.0) -> None:
        """Wait for a message with these `words`; raises `TimeoutError` when none comes

        Args:
            words: That a message must contain
            name: Of its logger; empty is any
            timeout: Seconds
        """

class Quick(MAVCom):
    "A `MAVCom` in which hearts beat fifty times faster, and silence is noticed as much sooner"
    beat_period: float
    lost_after: float

__all__ = ['Logged', 'Quick']
