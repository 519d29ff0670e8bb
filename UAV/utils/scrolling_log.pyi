"Show the newest messages on a picture, in a notebook's cell, or in a terminal."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
from typing import Any
from typing_extensions import Self


class ScrollingLog:
    "The newest messages, to draw on a picture or to watch in a notebook"
    max_lines: int
    position: tuple | None
    color: tuple
    bg_color: tuple | None
    thickness: int
    font_scale: float
    log: Any
    def __init__(
            self, max_lines: int = 5, position: tuple | None = None, color: tuple = ..., bg_color: tuple | None = None,
            thickness: int = 2, font_scale: float = 1.0,
    ) -> None:
        """
        Args:
            max_lines: Lines kept
            position: Left end of the first base line, (x,y) pixels; `None` is the upper left
            color: BGR
            bg_color: BGR of a box behind each line; `None` draws no box
            thickness: Of the letters, pixels
            font_scale: For a picture 1000 pixels high; smaller ones get smaller letters
        """
    def update(self, message: str, index: Any = None) -> None:
        """Add a line, or replace one; raises `IndexError` when there is no such line

        Args:
            message: One line
            index: Replace this line, 0 is the oldest; `None` appends
        """
    def draw(self, image: Any, font: int = 0) -> None:
        """Draw the lines on `image`

        Args:
            image: BGR picture, changed in place
            font: One of OpenCV's `FONT_HERSHEY_…`
        """
    def show(self, out: Any = None) -> None:
        """Show the log here and keep it up to date

        Args:
            out: Text stream to write to; `None` is the cell in a notebook, and the terminal elsewhere
        """

class ScrollingLogHandler(logging.Handler):
    "Puts the messages of a logger into a `ScrollingLog`, until `close`"
    scrolling_log: ScrollingLog
    logger: logging.Logger
    def __init__(
            self, scrolling_log: ScrollingLog, logger: logging.Logger, _filter: str = '',
            format: str = '%(levelname)s - %(message)s',
    ) -> None:
        """
        Args:
            scrolling_log: Where the messages go
            logger: Where they come from; the handler adds itself
            _filter: Only messages that contain this; empty takes all
            format: As for `logging.Formatter`
        """
    def close(self) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def emit(self, record: Any) -> None:
        "Put one message into the log; `logging` calls this"
    def set_filter(self, _filter: str) -> None:
        "Take only messages that contain `_filter`"

__all__ = ['ScrollingLog', 'ScrollingLogHandler']
