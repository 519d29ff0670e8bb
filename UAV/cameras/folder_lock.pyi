"One camera for one folder: a lock that ends with its process, and says which process has it."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any

def lock_file(file: Any) -> None:
    "Lock an open file, or raise `OSError`; the lock ends when the file is closed"

class FolderLock:
    "Keeps a folder for one owner, until `release` or the end of the process"
    path: Any
    file: Any
    def __init__(self, folder: Path) -> None:
        """Raises `StorageInUse` when another has it; warns when the folder cannot be locked, or has no room for a name

        Args:
            folder: Must exist
        """
    @property
    def here(self) -> bool:
        "Is the file in the folder still the one that we have locked?"
    def release(self) -> None:
        "Let others have the folder; one that is read-only by now keeps the file"
    def renew(self) -> None:
        "Lock the folder again when our file is not in it any more; raises `StorageInUse` and `OSError`"

__all__ = ['lock_file', 'FolderLock']
