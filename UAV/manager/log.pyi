"Each button of the panel has a state, and each press a line in a log: which button, of which camera, with which result, and how long it took."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from enum import Enum
from typing import Any


class Btn_State(Enum):
    "What a button shows"
    READY = 0
    RUNNING = 1
    DONE = 2
    FAILED = 3
    CANCELLED = 4

@dataclass
class Entry:
    "One press of a button"
    number: int
    who: str
    what: str
    at: float
    state: Btn_State = ...
    text: str = ...
    took: float | None = ...
    def status(self) -> dict:
        "The same as plain values"

class CommandLog:
    "The newest presses, and the state of each button"
    most: int
    longest: int
    entries: list
    def __init__(self) -> None: ...
    def __len__(self) -> Any: ...
    def begin(self, who: str, what: str) -> Entry:
        "A button was pressed"
    def end(self, entry: Entry, state: Btn_State, text: str = '') -> None:
        "It is clear what came of it"
    def state_of(self, who: str, what: str) -> Btn_State:
        "The state of a button"
    def forget(self, who: str) -> None:
        "A camera or gimbal has gone for good: its buttons are ready again"

__all__ = ['Btn_State', 'Entry', 'CommandLog']
