"The file that keeps one line for each shot: it survives crashes, and passes over lines that are damaged."
# Written by .ci/stubs.py from the live classes: do not edit.
import re
from UAV.cameras.values import Picture
from UAV.utils.values import Value
from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

def write_file(path: Path, content: bytes) -> None:
    """Write a file completely or not at all; raises `OSError`

    Args:
        path: Replaced when it is there
        content: All of it
    """
def append_line(path: Path, line: bytes) -> None:
    """Add a line to a file completely or not at all; raises `OSError`

    Args:
        path: Made when it is not there
        line: With its end
    """
def names_in(path: Path, pattern: re.Pattern) -> list:
    """The names in a list that can be ours, each once

    Args:
        path: A list, one name a line; it need not be there
        pattern: What our names look like
    """
def picture_in(path: Path, index: int) -> Picture | None:
    """The picture in a file, if it was saved as `index`, whatever the log says

    Args:
        path: Of the file
        index: From 0
    """
def file_names(folder: Path, index: int, kept: list | tuple = ...) -> list:
    """The names for picture `index` that are taken; the last one is free

    Args:
        folder: Of the pictures
        index: From 0
        kept: Names of pictures of earlier counts
    """
def orphan(folder: Path, index: int, kept: list | tuple = ...) -> Picture | None:
    """The newest picture that was saved as `index`, whatever the log says, if there is one

    Args:
        folder: Of the pictures
        index: From 0
        kept: Names of pictures of earlier counts
    """

@dataclass(frozen=True, repr=False, eq=False)
class Count(Value):
    "A line of a log: its pictures belong to this count, and the next one has this index"
    name: str
    first: int
def count_line(count: Count) -> bytes:
    "`count` as one line of a log"
def read_line(line: bytes) -> Any:
    """The `Picture` or the `Count` of a line; raises `ValueError` when it is damaged

    Args:
        line: Of a log
    """

class ShotLog:
    "What a log says; a log that is not there is empty"
    path: Path
    pictures: dict
    elsewhere: list
    count: Any
    next_index: Any
    most: Any
    whole: Any
    def __init__(self, path: Path) -> None:
        """
        Args:
            path: Of the log
        """
    def missing(self) -> list:
        "Indexes of which this log should know, and does not"
def log_lines(pictures: list, count: str = '', next_index: int = 0) -> Generator[Any, None, None]:
    """The lines of a log, one by one

    Args:
        pictures: By index
        count: Which count; empty: it has no name, as there is no other storage
        next_index: Of the next picture
    """

__all__ = [
    'write_file', 'append_line', 'names_in', 'picture_in', 'file_names', 'orphan', 'Count', 'count_line', 'read_line',
    'ShotLog', 'log_lines',
]
