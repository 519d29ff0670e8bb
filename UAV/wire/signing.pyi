"Only the holder of a key can make a signed frame, and the same frame is not accepted a second time."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.timestamps import TimestampFile
from collections import Counter
from logging import Logger
from pathlib import Path
from typing import Any
from typing_extensions import Self

log: Logger
def secret_key(key: bytes | str | Path) -> bytes:
    """The 32 bytes of a key; raises `ValueError` or `TypeError` for what is none, `OSError` for a missing file

    Args:
        key: 32 bytes; a passphrase; or the path of a file with 32 bytes, 64 hex digits or a passphrase
    """

class Reserve:
    "Keeps a file ahead of the timestamps in use: ours, and those that were accepted"
    period: int
    lead: int
    file: TimestampFile | Any
    ours: Any
    streams: Any
    def __init__(self, state: Path | str | bool | None, fingerprint: str, most: int) -> None:
        """
        Args:
            state: Path of the file; `None`: one for each key in the user's state folder; `False`: none
            fingerprint: Of the key
            most: Streams in the file
        """
    def load(self) -> tuple:
        "`(timestamp, streams)` to begin with; what we send is later than all that we may have accepted"
    def cover(self, timestamp: int, streams: dict, now: int, stream: tuple | None = None) -> None:
        """Write when the file is not ahead of these any more, or soon will not be

        Args:
            timestamp: Ours, that is used now
            streams: `{stream: newest accepted}`
            now: By the clock
            stream: The one from which a frame came
        """
    def settle(self, timestamp: int, streams: dict) -> None:
        "Write the exact timestamps; afterwards more may still be used"

class Signing:
    "Signs the frames that we send, and judges those that we get; any number of threads and links may share one"
    minute: int
    most: int
    fingerprint: Any
    clock: Any
    accept_unsigned: Any
    dropped: Counter
    reserve: Reserve
    timestamp: Any
    streams: Any
    def __init__(
            self, key: bytes | str | Path, state: Path | str | bool | None = None, accept_unsigned: Any = ...,
            clock: Any = ...,
    ) -> None:
        """
        Args:
            key: 32 bytes, a passphrase, or the path of a file with the key
            state: File for timestamps; `None`: one a key in the state folder; `False`: none
            accept_unsigned: Message ids, or a function of id and source
            clock: UNIX time
        """
    @property
    def file(self) -> Any:
        "Where the reserved time is kept"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def sign(self, frame: bytes, link_id: int = 0) -> bytes:
        """`frame` with a signature; MAVLink 1 frames and signed ones come back as they are

        Args:
            frame: A whole frame
            link_id: A number for each link, 0 … 255
        """
    def check(self, frame: bytes, msg_id: int, source: tuple) -> bool:
        """Is `frame` to be believed? What is not is counted in `dropped`: `unsigned`, `wrong`, `replayed` or `old`

        Args:
            frame: A whole frame, its CRC checked
            msg_id: Its message id
            source: `(system, component)` that sent it
        """
    def close(self) -> None:
        "Write the exact timestamps; frames may still be signed and checked afterwards"

__all__ = ['log', 'secret_key', 'Reserve', 'Signing']
