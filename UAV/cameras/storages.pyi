"Pictures go to one storage and videos to another, as you choose; the camera counts its pictures over all of them."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.storage import Storage
from UAV.cameras.values import Picture, StorageInformation
from collections.abc import Sequence
from typing import Any


class Storages:
    "The storages of one camera, numbered from 1; one count of pictures"
    media: Sequence
    all: tuple
    places: Any
    def __init__(self, *storages: Storage) -> None:
        """
        Args:
            storages: The first one also remembers what the others are for
        """
    def __len__(self) -> Any: ...
    def __iter__(self) -> Any: ...
    def __getitem__(self, i: Any) -> Any: ...
    def after_fork(self) -> None:
        "In a forked process: begin with a lock of its own"
    def close(self) -> None:
        "Close them all"
    def numbered(self, storage_id: int) -> Storage:
        """One storage; raises `ValueError` when it is not there

        Args:
            storage_id: From 1
        """
    def place_of(self, medium: str) -> Storage:
        """Where a medium goes now; raises `ValueError`

        Args:
            medium: 'photo' or 'video'
        """
    @property
    def photo(self) -> Any:
        "Where pictures go now; its log counts"
    def usage(self, storage_id: int) -> tuple:
        """What a storage is for

        Args:
            storage_id: From 1
        """
    @property
    def next_index(self) -> int:
        "Index of the next picture, and how many there were in this count"
    def check_room(self) -> None:
        "Raise what speaks against another picture: `StorageError`, `StorageFull` or `CameraBusy`"
    def save(self, *picture: Any) -> Picture:
        """Keep one picture where pictures go now; raises `StorageFull` or `StorageError`

        Args:
            picture: As for `Storage.save`
        """
    def fail(self, time_utc: float, error: str = '') -> Picture:
        """Keep the record of a shot that failed

        Args:
            time_utc: When it was tried, s since 1970
            error: Why it failed
        """
    def set_usage(self, storage_id: int, usage: Any) -> list:
        """The storages whose usage changed; raises `ValueError`, `StorageError`, or `CameraBusy` during a format

        Args:
            storage_id: From 1
            usage: What it is for from now on: a set of 'photo' and 'video'
        """
    def picture(self, index: int) -> Picture:
        """One shot of this count; raises `IndexError` when there is none

        Args:
            index: From 0
        """
    @property
    def pictures(self) -> list:
        "All shots of this count that are in a log, by index"
    def information(self) -> list:
        "How full they are, and what they are for"
    def about(self, storage: Storage) -> StorageInformation:
        """How full one of them is, and what it is for

        Args:
            storage: One of ours
        """
def media_in(usage: Any) -> set:
    """The media in a usage; raises `ValueError`

    Args:
        usage: A set of 'photo' and 'video', or one of them
    """

__all__ = ['Storages', 'media_in']
