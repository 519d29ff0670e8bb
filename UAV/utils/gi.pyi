"Find the system's GStreamer, and its binding for Python, from any virtual environment."
# Written by .ci/stubs.py from the live classes: do not edit.
from pathlib import Path
from typing import Any

system_folders: list
def gi_folder(folders: Any = None) -> Path | None:
    """The folder with a `gi` that was compiled for this Python; `None` when there is none

    Args:
        folders: Where to look; `None`: `system_folders`
    """

class SystemGi:
    "Finds `gi`, and nothing else, among the packages of the system"
    @staticmethod
    def find_spec(name: Any, path: Any = None, target: Any = None) -> Any:
        "For Python's `import gi`: where the system has it; `None` when it has none"
apt_line: str

class GStreamerMissing(ImportError):
    "GStreamer, or its binding for this Python, is not installed"
def what_is_missing(folders: Any = None) -> str:
    """A sentence about what is missing, with the line that installs it

    Args:
        folders: Where to look; `None`: `system_folders`
    """
def load_gst() -> Any:
    "GStreamer's module `Gst`, ready for use; raises `GStreamerMissing`"

__all__ = ['system_folders', 'apt_line', 'gi_folder', 'SystemGi', 'GStreamerMissing', 'what_is_missing', 'load_gst']
