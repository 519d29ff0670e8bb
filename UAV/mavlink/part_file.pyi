"Keep a download as a `.part` until it is whole, so that it can go on later and never overwrites another."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any

def open_part(to: Path) -> Any:
    """The `.part` of a download, open and ours alone; `.2.part` when another download has it. Raises `OSError`

    Args:
        to: The file that is to be there in the end
    """
def place_on_disk(to: str | Path, name: str) -> Path:
    """Where a file goes; raises `OSError`

    Args:
        to: A file, or a folder that is there
        name: Of the file in that folder
    """

__all__ = ['open_part', 'place_on_disk']
