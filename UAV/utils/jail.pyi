"Open files that others name, below one folder and nowhere else."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

most_bytes: int
def not_found(path: Any) -> FileNotFoundError:
    "The error for a path that is not there"
def names_of(path: str) -> tuple:
    """The names of the folders and the file in a path; raises `FileNotFoundError` for what cannot be one

    Args:
        path: With slashes, as others write it
    """
@contextmanager
def folder_below(root: Path, names: tuple) -> Generator[Any, None, None]:
    """For a `with`: the descriptor of a folder; raises `OSError`

    Args:
        root: May be reached through a link
        names: Of folders, one in the other
    """

class Jail:
    "A folder, and what is below it; no symbolic link is followed"
    folder: Path
    def __init__(self, folder: str | Path) -> None:
        """
        Args:
            folder: The folder; it may come and go
        """
    @contextmanager
    def at(self, names: tuple) -> Generator[Any, None, None]:
        """For a `with`: a name and a `dir_fd`, to be given to a function of `os`

        Args:
            names: From `names_of`; at least one
        """
    def open(self, names: tuple, flags: int = ...) -> Any:
        """The open file, not buffered; raises `OSError`

        Args:
            names: From `names_of`
            flags: As for `os.open`
        """
    def entries(self, names: tuple = ...) -> list:
        """A `FileEntry` for all that is in a folder; raises `OSError`

        Args:
            names: Of the folder
        """
    def entry(self, names: tuple) -> FileEntry:
        """The `FileEntry` of one; raises `OSError`

        Args:
            names: Of a file or a folder
        """
    def unlink(self, names: tuple) -> None:
        "Remove a file; raises `OSError`"
    def mkdir(self, names: tuple) -> None:
        "Make a folder in one that is there; raises `OSError`"
    def rmdir(self, names: tuple) -> None:
        "Remove an empty folder; raises `OSError`"
    def rename(self, names: tuple, to: tuple) -> None:
        "Give a file or a folder another name, which must be free; raises `OSError`"

class FileEntry(NamedTuple):
    "A file or a folder, as it stands in a listing"
    name: str
    size: int = ...
    time: float = ...
    folder: bool = ...

__all__ = ['most_bytes', 'not_found', 'names_of', 'folder_below', 'Jail', 'FileEntry']
