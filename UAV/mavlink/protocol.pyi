"Tell for whom a message is and what an ack means, and wait for an answer in a coroutine: plain values, with no socket and no thread."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.dialect import MAVError
from typing import Any
from typing_extensions import Self

def accepts(msg: Any, source_system: int, source_component: int) -> bool:
    """Is `msg` addressed to this component, or to all?

    Args:
        msg: Any MAVLink message
        source_system: Our own system id
        source_component: Our own component id
    """
def comes_from(msg: Any, system: int | None, component: int | None) -> bool:
    "Was `msg` sent by this system and component? `None` and 0 fit any"

class NoAnswer(MAVError, TimeoutError):
    "No answer came in time"

class Lost(NoAnswer):
    "The component we wait for was heard before, and is silent now"

class CommandError(MAVError):
    "A command that was answered, but not accepted; `result` is its MAV_RESULT"
    result: int

class Busy(CommandError):
    "Refused for now: it is busy with something else"
    result: int

class Denied(CommandError):
    "Refused: the parameters are wrong, or it is not allowed"
    result: int

class Unsupported(CommandError):
    "Refused: it does not know the command, or cannot do it"
    result: int

class Failed(CommandError):
    "It was tried, and failed"
    result: int

class Cancelled(CommandError):
    "It was ended before it was done"
    result: int
patience: float
longest_rto: float
remembered: float
shot_tries: int

class Answer:
    "What a coroutine waits for, and any thread may bring"
    def __init__(self) -> None: ...
    def set(self, value: Any) -> bool:
        "Bring `value`; false when one was there before. An exception is raised where we wait"
    async def wait(self, timeout: float | None = None) -> Any:
        """The value, or `None` when it is not there in time; raises it when it is an exception

        Args:
            timeout: Seconds; `None` waits as long as it takes
        """

class Command(Answer):
    "One command under way; its value will be the COMMAND_ACK, or `None`"
    def __init__(
            self, target: tuple, command_id: int, params: Any = ..., frame: int | None = None,
            timeout: float | None = None, retries: int | None = None, patience: float = ...,
    ) -> None:
        """
        Args:
            target: `(system, component)`; 0 is all
            command_id: A MAV_CMD
            params: Up to seven numbers
            frame: A MAV_FRAME makes it a COMMAND_INT
            timeout: Seconds until each next copy; `None`: as the round trips demand
            retries: How often to send it again; `None`: for `patience`; twice, to one that was never heard
            patience: Seconds after its first copy in which it is sent again
        """

class Outbox:
    "A lock, and calls that are made when it was let go; what they bring about is called after them, not within"
    def __init__(self) -> None: ...
    def add(self, f: Any, *args: Any) -> None:
        "Call `f(*args)` when the lock was let go"
    def __enter__(self) -> None: ...
    def __exit__(self, *args: Any) -> None: ...
    def flush(self) -> None:
        "Make the calls, unless another thread is at it: then it makes ours as well"

class Expected(Answer):
    "A message that we wait for; use it in a `with`"
    def __init__(self, expectations: Any, msg_id: int, fits: Any, source: tuple | None) -> None: ...
    def set(self, value: Any) -> bool: ...
    def renew(self) -> None:
        "Wait for the next one"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...

class Expectations:
    "Messages that somebody waits for, by their ids"
    wanted: Any
    def __init__(self, wanted: Any = None) -> None:
        """
        Args:
            wanted: The link's `Wanted`, which must know what to build
        """
    def add(self, msg_id: int, fits: Any = ..., source: tuple | None = None) -> Expected:
        """Wait for a message until `remove`

        Args:
            msg_id: MAVLINK_MSG_ID
            fits: A test that the right message passes
            source: `(system, component)`: we stop waiting when this one falls silent
        """
    def remove(self, expected: Expected) -> None:
        "Stop waiting; safe to call twice"
    def offer(self, msg: Any) -> None:
        "Give `msg` to those who expect it; who brought a test that fails gets its error"
    def lose(self, source: tuple | None, why: str) -> None:
        "All who wait for `source`, or all (`None`), get the error `Lost(why)`"

__all__ = [
    'patience', 'longest_rto', 'remembered', 'shot_tries', 'accepts', 'comes_from', 'NoAnswer', 'Lost', 'CommandError',
    'Busy', 'Denied', 'Unsupported', 'Failed', 'Cancelled', 'Answer', 'Command', 'Outbox', 'Expected', 'Expectations',
]
