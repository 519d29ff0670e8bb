"Send a message again and again to the component that asked for it, and stop when that component falls silent."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Stream:
    "One message, sent again and again"
    component: Any
    msg_id: int
    values: tuple
    period: float
    to: tuple | None
    failed: Any
    job: Any
    def __init__(self, component: Any, msg_id: int, values: tuple, period: float, to: tuple | None, failed: Any) -> None:
        """
        Args:
            component: Encodes and sends it
            msg_id: Which message
            values: Parameters of the request, such as an index
            period: µs
            to: `(system, component)` that gets it; `None`: all
            failed: Called with the stream when the message can no longer be made
        """
    def send(self) -> None:
        "Send it once"
    def stop(self, timeout: float = 5.0) -> None:
        """Send it no more

        Args:
            timeout: Seconds to wait for a message that is being made
        """

class Streams:
    "Streams and long answers of one component, by who asked for them"
    most_each: int
    most_askers: int
    tick: float
    component: Any
    clock: Any
    def __init__(self, component: Any, clock: Any = ...) -> None: ...
    def __len__(self) -> Any: ...
    def of(self, asker: tuple | None) -> dict:
        "`{(message id, *values): Stream}` of one asker"
    def end(self, asker: tuple | None, timeout: float = 5.0) -> None:
        """Nothing more for `asker`

        Args:
            asker: `(system, component)` that asked
            timeout: Seconds to wait for a message that is being made
        """
    def look(self) -> None:
        "End what belongs to askers that have fallen silent, and forget those who get nothing"
    def start(self, asker: tuple | None, msg_id: int, period: float, values: tuple = ..., everyone: bool = False) -> None:
        """Start a stream, in the place of the one before; raises `Denied` when it is too much for one, `Busy` for too many

        Args:
            asker: `(system, component)` that asked
            msg_id: Which message
            period: µs
            values: Parameters of the request
            everyone: Send it to all
        """
    def interval(self, asker: tuple | None, msg_id: int) -> float:
        "How often `asker` gets a message, µs; -1 when it does not"
    def stop(self, asker: tuple | None, msg_id: int, *values: Any) -> None:
        "Stop what `asker` gets of a message, a long answer too: with these first `values`, or all of it"
    def stop_for_all(self, msg_id: int, *values: Any) -> None:
        "Stop what anyone gets of a message"
    def close(self) -> None:
        "Stop all streams and answers, for good"
    def answer(self, asker: tuple, msg_id: int, msgs: Any, everyone: bool = False) -> None:
        """Send `msgs`, four at once and the rest paced; raises `Busy` while another long answer is under way

        Args:
            asker: `(system, component)` that asked
            msg_id: For which message
            msgs: The messages, or a generator of them
            everyone: Send them to all
        """

class LongAnswer:
    "Messages that are still to be sent to one asker"
    msg_id: int
    msgs: Any
    to: tuple | None
    def __init__(self, msg_id: int, msgs: Any, to: tuple | None) -> None: ...

__all__ = ['Stream', 'Streams', 'LongAnswer']
