"Choose which storage pictures and films go to, and format one: SET_STORAGE_USAGE and STORAGE_INFORMATION from both ends."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import StorageInformation
from typing import Any

def media_of(flags: int) -> set:
    """What a storage is to be for; raises `Denied` for flags that mean nothing to a camera

    Args:
        flags: STORAGE_USAGE_FLAG, with or without SET
    """
def storage_of(msg: Any) -> StorageInformation:
    """What a message tells; `usage` is `None` when it does not say

    Args:
        msg: A STORAGE_INFORMATION
    """

__all__ = ['media_of', 'storage_of']
