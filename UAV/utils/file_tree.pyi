"`FileTree` offers files from memory and folders of a disk under one root, and nothing else can be reached."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.jail import FileEntry, FileEntry as FileEntry, Jail, names_of as names_of
from pathlib import Path
from typing import Any, NamedTuple

def hidden(name: str) -> bool:
    "Is a file with this name of no interest to others: half written, or one that starts with a dot?"

class Mount(NamedTuple):
    "A folder of a disk, as part of a tree"
    jail: Jail
    writable: bool
    hide: Any

class FileTree:
    "Files and folders that others may see"
    def __init__(self) -> None: ...
    def add(self, path: str, content: Any) -> None:
        """Offer a file that is on no disk; it replaces the one before

        Args:
            path: Where it stands, such as `/camera.xml`
            content: Bytes, or a function that gives them, called for each reader
        """
    def mount(self, path: str, folder: str | Path, writable: bool = False, hide: Any = ...) -> None:
        """Offer a folder and all below it; it replaces the one before

        Args:
            path: Where it stands, such as `/media`
            folder: On a disk; it may come and go
            writable: May others write, rename and remove?
            hide: A function of a name: true when others must not see it, nor make it
        """
    def remove(self, path: str) -> None:
        "Offer it no more: a file that was added, or a folder that was mounted; what is on the disk stays"
    def open(self, path: str, mode: str = 'r') -> Any:
        """The open file, in bytes; raises `OSError`

        Args:
            path: As others write it
            mode: 'r' to read, 'w' to write anew, 'a' to write into what is there
        """
    def entries(self, path: str = '/') -> list:
        """A `FileEntry` for all that is in a folder; raises `OSError`

        Args:
            path: Of a folder
        """
    def entry(self, path: str) -> FileEntry:
        """The `FileEntry` of one; raises `OSError`

        Args:
            path: Of a file or a folder
        """
    def writable(self, path: str) -> bool:
        """May others change this?

        Args:
            path: Of a file or a folder, which need not be there
        """
    def change(self, what: str, path: str, *to: Any) -> None:
        """Change what is on the disk; raises `OSError`

        Args:
            what: 'unlink', 'mkdir', 'rmdir' or 'rename', as in `os`
            path: What is changed
            to: The new path, for 'rename'
        """
    def truncate(self, path: str, size: int) -> None:
        "Cut a file to `size` bytes; raises `OSError`, a `ValueError` when it is shorter"
def is_text(name: str) -> bool:
    "Can others name it?"

__all__ = ['hidden', 'Mount', 'FileTree', 'is_text', 'FileEntry', 'names_of']
