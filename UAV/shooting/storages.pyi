"See from a shell how full the storages of a camera are, choose what goes to which, and format one."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import StorageInformation
from typing import Any

def storage_object(storage: StorageInformation) -> dict:
    """What it tells, for programs; sizes in MiB

    Args:
        storage: One of a camera's
    """
def storage_text(storage: StorageInformation) -> str:
    """The same for people

    Args:
        storage: One of a camera's
    """
def usages(storages: list, wanted: dict) -> dict:
    """What to tell the camera of each storage that is named: `{number: media}`

    Args:
        storages: What the camera has, a `StorageInformation` each
        wanted: `{medium: number of the storage where it is to go}`
    """
def storage_number(text: str) -> Any: ...
async def list_storages(shooting: Any, photo: Any = None, video: Any = None) -> None:
    """The storages: how full they are, and what goes there

    Args:
        photo: Send pictures to this one from now on
        video: Send recordings to this one from now on
    """
async def format_storage(shooting: Any, storage: Any = 1, yes: bool = False) -> None:
    """Delete all that is on a storage

    Args:
        storage: Number of the storage
        yes: Do it: all pictures and recordings on it are lost
    """

__all__ = ['storage_number', 'storage_object', 'storage_text', 'usages', 'list_storages', 'format_storage']
