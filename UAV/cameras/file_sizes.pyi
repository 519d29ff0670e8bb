"How many bytes our files in a folder fill: we know it without asking the disk, until others remove some."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any

def file_size(path: Path) -> int:
    """Bytes, and 0 when it is gone

    Args:
        path: Of a file
    """

class FileSizes:
    "The sizes of our files in one folder, bytes"
    folder: Path
    settled: float
    sizes: dict
    sum: Any
    largest: Any
    def __init__(self, folder: Path, names: Any, settled: float = 2.5) -> None:
        """
        Args:
            folder: Ours and others' files lie here
            names: Of our files
            settled: s that the folder was left alone, until its time of change tells of the next change
        """
    def add(self, name: str, size: int) -> None:
        "One file more, of `size` bytes"
    def there(self) -> int:
        "Bytes of our files that are there. Raises `OSError` when the folder is gone"

__all__ = ['file_size', 'FileSizes']
