"Give a browser the newest picture of a camera as a JPEG, only while a viewer looks, and say how the stream is."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections import deque
from typing import Any


class Newest:
    "The newest picture, numbered over all players, and when the last ones came"
    most: int
    window: float
    widest: int
    small: int
    last: tuple
    first: Any
    times: deque
    def __init__(self) -> None: ...
    def begin(self) -> None:
        "From now on they come from another player"
    def put(self, frame: Any) -> None:
        "This one has come"
    @property
    def number(self) -> int:
        "Of the newest picture; -1 when none has come"
    @property
    def size(self) -> tuple | None:
        "(width, height) of the newest picture, px"
    def when(self, number: int) -> float | None:
        """When it came, monotonic s; the oldest time that is known when it is forgotten, `None` when none has come

        Args:
            number: Of a picture
        """
    def rate(self, now: float) -> float:
        """Pictures in a second, lately

        Args:
            now: Monotonic s
        """
    def thumbnail(self) -> bytes:
        "The newest picture as a small JPEG"
    def numbered(self) -> tuple:
        "`(number, JPEG)` of the newest picture"
def jpeg_of(frame: Any, widest: int, quality: int = 75) -> bytes:
    """A picture as a JPEG that is not wider than that

    Args:
        frame: A `Decoded`
        widest: px
        quality: %
    """

class Preview:
    "The live picture of a camera, while a viewer looks"
    lease: float
    patience: float
    least: float
    pause: float
    long_pause: float
    client: Any
    target: tuple
    news: Any
    streams: Any
    chosen: int | Any
    fault: Any
    newest: Newest
    player: Any
    sinks: list
    def __init__(self, client: Any, target: tuple, news: Any = ...) -> None:
        """
        Args:
            client: A `CameraClient`
            target: `(system, component)` of the camera
            news: Called when something has changed
        """
    @property
    def wanted(self) -> bool:
        "Is a viewer looking, or recording?"
    @property
    def stream(self) -> Any:
        "The stream that is shown: the chosen one, else the first; `None` when there is none"
    async def find(self) -> None:
        "Ask the camera which streams it has; raises `MAVError`"
    @property
    def silent(self) -> float:
        "Seconds since the last picture, or since the stream was opened"
    @property
    def begun(self) -> bool:
        "Has a picture come since the stream was opened?"
    @property
    def live(self) -> bool:
        "Has a picture of this stream come just now?"
    @property
    def state(self) -> tuple:
        "'none', 'idle', 'waiting', 'running' or 'lost'; and why"
    def status(self) -> dict:
        "The same, and size and rate, as plain values"
    async def run(self) -> None:
        "Open the stream when a viewer looks, and close it when none does; until cancelled"
    def look(self) -> None:
        "A viewer looks: the stream is opened, and stays open for a while"
    async def picture(self, after: int = -1) -> tuple | None:
        """`(number, JPEG)` of the newest picture, when it is later; the last one stays when there is no stream

        Args:
            after: Number of the last picture that the viewer has
        """
    def reopen(self) -> None:
        "Ask the camera anew for its streams, and open one, if a viewer looks"
    def choose(self, stream_id: int) -> None:
        """Show this stream; raises `ValueError` when there is no such one

        Args:
            stream_id: As in `streams`
        """
    def add_sink(self, sink: Any) -> None:
        """Give it all that is received; the stream stays open

        Args:
            sink: A `Sink`: gets the access units, from the next key picture on
        """
    def remove_sink(self, sink: Any) -> None:
        "Give it nothing more; safe to call twice"

__all__ = ['Newest', 'jpeg_of', 'Preview']
