"The time of a signed frame, and a small file that remembers it over a restart."
# Written by .ci/stubs.py from the live classes: do not edit.
from logging import Logger
from pathlib import Path
from typing import Any

fcntl: Any
log: Logger
latest: int
def ticks(seconds: float) -> int:
    "UNIX time as the timestamp of a signature"
def state_file(fingerprint: str) -> Path:
    """Where the timestamps of the key with this fingerprint are kept

    Args:
        fingerprint: Of a key
    """

class TimestampFile:
    "Keeps the timestamps of one key; any number of processes may share it"
    most: int
    path: Path
    id: Any
    def __init__(self, path: Any, most: int = 1024) -> None:
        """
        Args:
            path: Of the file; it and its folder are made when they are needed
            most: Streams in the file, the newest
        """
    def load(self) -> tuple:
        "`(timestamp, streams)` to begin with; a file that makes no sense is one warning"
    def save(self, timestamp: int, streams: dict, wait: bool = True, sync: bool = False, exact: bool = False) -> bool:
        """Write the latest timestamps; false if another program is writing just now

        Args:
            timestamp: Ours: the file will hold this one, or a later one that it holds already
            streams: `{(system, component, link id): timestamp}`
            wait: For the lock
            sync: Wait for the disk, too
            exact: Go back to these timestamps if no other program has written
        """

__all__ = ['log', 'latest', 'ticks', 'state_file', 'TimestampFile']
