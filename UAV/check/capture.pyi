"Watch a camera take a picture: make it ready, send the command, and compare the notices with its count."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

modes: dict

class Shot:
    "One command that takes pictures, and what came of it"
    answer: Any
    notices: list
    before: Any
    after: Any
    def __init__(self, answer: Any, notices: list, before: Any, after: Any) -> None: ...
    @property
    def taken(self) -> int:
        "How many pictures, by the camera's own count; by its notices when it does not count"

__all__ = ['modes', 'Shot']
