"`Storage` keeps the pictures of one camera in a folder: it counts the shots, survives crashes, and lets no other camera in."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import CameraInformation, Picture, Pose, StorageInformation
from pathlib import Path
from typing import Any
from typing_extensions import Self

MiB: int
storage_kinds: tuple

class Storage:
    "The pictures of one camera, in a folder that outlives crashes; raises `StorageInUse` when it is another storage's"
    settled: float
    quota: float | None
    reserve: float
    storage_id: int
    name: str
    format_time: float
    kind: str
    formatting: bool
    folder: Path
    kept: Any
    count: Any
    next_index: Any
    pictures: list
    def __init__(
            self, folder: str | Path | None = None, quota: float | None = None, reserve: float = 50.0, storage_id: int = 1,
            name: str = 'pictures', kind: str = 'other', format_time: float = 0.0,
    ) -> None:
        """
        Args:
            folder: Where pictures go; `None` is a temporary folder that `close` removes
            quota: MiB the pictures may fill; `None` is the whole disk
            reserve: MiB of the disk that stay free
            storage_id: From 1; a camera with several numbers them itself
            name: For people
            kind: One of `storage_kinds`
            format_time: s that a format takes, as on a slow card
        """
    def __len__(self) -> Any: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "Let others have the folder, and remove it if it was a temporary one; what is known of the pictures stays"
    @property
    def log_file(self) -> Path:
        "The log, one JSON line a shot"
    @property
    def recordings(self) -> list:
        "The files of our recordings, oldest first"
    def is_writable(self) -> bool:
        "Can anything be written here? Not on a card that is locked, or a disk that has become read-only"
    def information(self) -> StorageInformation:
        "How full the storage is, MiB; 'empty' when its folder is gone, 'unformatted' when a format could not be finished"
    def check_closed(self) -> None:
        "Raise `StorageError` when it is closed"
    def check_folder(self) -> None:
        "Raise `StorageError` when its folder cannot be written to, `StorageInUse` when it was made anew, and is another's"
    def check_room(self, size: int | None = None) -> None:
        """Raise `StorageError` (closed, gone, read-only), `StorageFull` unless `size` fits, `CameraBusy` during a format

        Args:
            size: Bytes; `None`: as large as the largest picture so far
        """
    def save(
            self, jpeg: bytes, time_utc: float, pose: Pose | None = None, information: CameraInformation | None = None,
            tags: dict | None = None,
    ) -> Picture:
        """Keep one picture, with metadata; raises `StorageFull` or `StorageError`, and leaves nothing behind

        Args:
            jpeg: A JPEG file
            time_utc: When it was taken, s since 1970
            pose: Where it was taken
            information: Which camera took it
            tags: More EXIF tags, by their names
        """
    def fail(self, time_utc: float, error: str = '') -> Picture:
        """Keep the record of a shot that failed

        Args:
            time_utc: When it was tried, s since 1970
            error: Why it failed
        """
    def format(self, cancelled: Any = ...) -> None:
        """Delete our pictures, our recordings and the log; indexes start again at 0. Raises `StorageError`, `TakenBack`

        Args:
            cancelled: Says whether it is to end without having deleted anything
        """
    def reset_log(self) -> None:
        "Count from 0 again; the pictures stay. Raises `StorageError`"
    def join(self, count: str, next_index: int) -> None:
        """Go on with a count; pictures of another count leave the log. Raises `StorageError`

        Args:
            count: Its name; 1 to 40 letters and figures
            next_index: Of the next picture
        """
    def name_count(self, count: str) -> None:
        """Give our count a name, so that another storage can join; a storage that is gone is told all the same

        Args:
            count: Its name
        """
    def find(self, index: int) -> Picture | None:
        """The shot with this index, if it is in our log; does not wait for one that is being saved

        Args:
            index: From 0
        """
    @property
    def video_log(self) -> Path:
        "The names of our recordings, one a line"
    def new_recording(self) -> Path:
        "The path of the next file of a recording, which is ours from now on; raises `StorageError`"
    def be_number(self, number: int) -> None:
        """A camera has given us another number

        Args:
            number: From 1
        """
    @property
    def temporary(self) -> bool:
        "Does the folder go when the storage is closed?"
lost_line: str

__all__ = ['MiB', 'storage_kinds', 'lost_line', 'Storage']
