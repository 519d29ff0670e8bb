"Draw a message log as a sequence chart: a lane for each component, an arrow for each message."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.svg import Drawing
from UAV.wire.exchanges import Lane, Row
from UAV.wire.message_log import MessageLog
from dataclasses import dataclass
from typing import Any

colours: dict
row_height: int
first_row: int
least_gap: int
margin: int
head_top: int
head_height: int
head_padding: int
bar_width: int
bar_step: int
number_column: int
time_column: int
legend_line: int

@dataclass
class Line:
    "A row in its place"
    row: Row
    place: int
    number: int
    words: str
    start: Lane
    ends: list
    middle: float = ...
    @property
    def y(self) -> int:
        "Pixels, from the top"
    @property
    def leftmost(self) -> int:
        "The first lane it is on"
    @property
    def rightmost(self) -> int:
        "The last lane it is on"
    @property
    def gap(self) -> int:
        "The words stand right of the lane with this index"
def lines_of(rows: list, lanes: dict) -> list:
    "Each of `rows` as a `Line`"

@dataclass
class Bar:
    "A command under way, on the lane of the component that answers it"
    lane: Lane
    first: int
    last: int
    kind: str
    missing: bool
    depth: int = ...
    def covers(self, place: int) -> bool:
        "Is it beside the line at `place`?"
    def overlaps(self, other: Bar) -> bool:
        "Are they beside the same line?"
def bars_of(lines: list) -> list:
    "A `Bar` for each component that answers, or should have answered, a command"

class Chart:
    "Who said what to whom, as SVG; shows itself in a notebook"
    times: bool
    lanes: dict
    lines: list
    bars: list
    width: Any
    bottom: Any
    notes: Any
    def __init__(
            self, log: MessageLog, names: tuple = ..., rows: int = 60, times: bool = False, counts: bool = True,
    ) -> None:
        """
        Args:
            log: What passed
            names: Messages to draw; none: the `usual` ones of the log, and what was asked for by REQUEST_MESSAGE
            rows: Draw the newest
            times: Draw a ruler of seconds as well
            counts: Say how many heartbeats and other messages were left out
        """
    @property
    def drawing(self) -> Drawing:
        "The picture"
    @property
    def svg(self) -> str:
        "The picture as text"
    def save(self, file: Any) -> None:
        "Write the picture as an `.svg`"

__all__ = [
    'colours', 'row_height', 'first_row', 'least_gap', 'margin', 'head_top', 'head_height', 'head_padding',
    'bar_width', 'bar_step', 'number_column', 'time_column', 'legend_line', 'Line', 'lines_of', 'Bar', 'bars_of',
    'Chart',
]
