"List, download and remove the files of a camera from a shell."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def path_below(folder: str, name: str) -> str:
    """The path of a file in a folder

    Args:
        folder: Path of a folder on the camera
        name: In it
    """
def time_text(moment: float) -> str:
    """When that was, here; nothing when it is not known, or cannot be

    Args:
        moment: s since 1970; 0: not known
    """
async def list_camera_files(shooting: Any, paths: list[str]) -> None:
    """Which files the camera has, and how large they are

    Args:
        paths: Folders on the camera; none: where its files begin
    """
async def fetch_files(shooting: Any, paths: list[str], to: str = '.') -> None:
    """Bring files here; no file that is here is overwritten

    Args:
        paths: Of files on the camera, or of folders
        to: Folder here, where they are to go
    """
async def remove_files(shooting: Any, paths: list[str], yes: bool = False) -> None:
    """Delete files on the camera, if it lets you

    Args:
        paths: Of files on the camera
        yes: Do it
    """

__all__ = ['path_below', 'time_text', 'list_camera_files', 'fetch_files', 'remove_files']
