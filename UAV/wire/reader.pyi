"`FrameReader` takes bytes from a link, and gives only the messages that a component wants."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Wanted:
    "Message ids that are wanted, counted; `None` means all of them"
    counts: dict
    def __init__(self, *msg_ids: Any) -> None: ...
    def __contains__(self, msg_id: Any) -> Any: ...
    def add(self, *msg_ids: Any) -> None:
        "Want these messages, once more each"
    def remove(self, *msg_ids: Any) -> None:
        "Want these messages once less each"

class Source:
    "What was heard of one component: frames by message id, and how many were lost on the way"
    enough: int
    longest_gap: int
    counts: dict
    next: Any
    missing: int
    doubled: int
    beside: dict
    skipped: int
    restarts: int
    def __init__(self) -> None: ...
    @property
    def received(self) -> Any:
        "How many frames were heard of it"
    def restart(self) -> None:
        "Numbers begin anew: the sender was restarted, or was out of reach for too long to tell"
    def gap(self, seq: int) -> Any:
        "`seq` is not the next number: others are missing, or (128 ahead or more) it comes late or again"
    @property
    def loss(self) -> float:
        "What part was lost on the way, at most: what is missing here, or of the one most heard through the same peer"
    @property
    def lost(self) -> int:
        "How many of its frames were lost on the way, as far as `loss` can say"

class Sources(dict):
    "`{(system,component): Source}`, which several readers may share; `cleared` counts how often some were thrown out"
    most: int
    cleared: int
    def source(self, key: tuple) -> Source:
        "The `Source` of `key`; when there are too many, those go of which least was heard"

class FrameReader:
    "Cuts frames out of a byte stream; `feed` returns the messages among them that are wanted"
    most_kinds: int
    wanted: Wanted
    datagrams: bool
    check: Any
    only_signed: bool
    sources: Any
    bad: Any
    seen: dict
    def __init__(
            self, wanted: Wanted, sources: Sources | None = None, datagrams: bool = False, check: Any = None,
            only_signed: bool = False,
    ) -> None:
        """
        Args:
            wanted: Message ids: messages with other ids are counted, not built
            sources: To share between readers
            datagrams: Does data begin with a frame, as in UDP?
            check: Called with `(frame, msg_id, (system,component))` of each good frame: is it to be believed?
            only_signed: Is a sender known (`seen`) only by a frame with a signature?
        """
    def feed(self, data: bytes) -> list:
        "The wanted messages that are complete with `data`"
    def restart(self) -> None:
        "Forget half a frame and the numbers: what comes now is from a new connection"

__all__ = ['Wanted', 'Source', 'Sources', 'FrameReader']
