"A small MAVLink peer that plays several programs, sends exactly what it is told, and reads the answer in the record."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.check.capture import Shot
from UAV.check.ftp import FtpPacket
from UAV.check.judge import Row
from UAV.check.parameters import ParamExt
from UAV.check.record import Heard, Recorder
from UAV.check.requirement import Requirement
from UAV.check.suite import Findings
from UAV.wire.lossy import LossyLink
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any
from typing_extensions import Self


class Prober:
    "Plays peers of a camera, and records what comes"
    link: LossyLink
    recorder: Recorder
    target: Any
    patience: float
    quiet: float
    role: Any
    information: Any
    known: dict
    def __init__(self, connection: Any, target: tuple | None = None, patience: float = 3.0, quiet: float = 1.0) -> None:
        """
        Args:
            connection: Connection string, or a `Link`
            target: `(system, component)` of the camera; `None`: the one that is heard
            patience: s in which an answer must come
            quiet: s without one that mean "no more"
        """
    def close(self) -> None:
        "Close the link"
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    @property
    def address(self) -> tuple:
        "`(system, component)` that we play"
    @property
    def mav(self) -> Any:
        "The encoder of our role"
    def send(self, msg: Any) -> int:
        "Send a message; the place in the record before any answer to it"
    def beat(self) -> None:
        "Our heartbeat, when it is time; an autopilot that we play has none, as the real one would not like that"
    def ours(self, heard: Heard) -> bool:
        "Did the camera send it?"
    def wait_any(self, fits: Any, timeout: float, since: int = 0) -> Heard | None:
        "The first message that fits, from any sender; our heartbeats go on meanwhile"
    def wait(self, name: str, since: int, fits: Any = ..., timeout: float | None = None) -> Any:
        """The first message of the camera that fits, or `None`

        Args:
            name: Of a message
            since: Where in the record to begin
            fits: What else must be true of it
            timeout: s; `None`: our patience
        """
    def came(self, name: str, since: int, fits: Any = ...) -> list:
        "What the camera sent of this name, each a `Heard`"
    def listen(self, seconds: float | None = None) -> None:
        "Let time pass; `None`: until it is clear that no more comes"
    def long(self, command: str | int, *params: float, to: tuple | None = None, confirmation: int = 0) -> Any:
        "A COMMAND_LONG of our role, which broadcasts when it is ArduPilot; the rest of its parameters are unused"
    def acks(self, command: int, since: int) -> list:
        "The camera's acks of a command, to us or to all"
    def await_ack(self, command: int, since: int, timeout: float | None = None) -> list:
        "All acks of a command until the last one"
    def do(self, msg: Any, timeout: float | None = None) -> Acks:
        "Send a COMMAND_LONG or COMMAND_INT, once, and wait for its ack"
    def command(self, command: str | int, *params: float, **options: Any) -> Acks:
        "Send a COMMAND_LONG, and wait for its ack; repeat it when our role has a bad radio"
    def ask(self, name: str, *params: float, **options: Any) -> tuple:
        "`(answer, message)` of a REQUEST_MESSAGE; the message is `None` when it did not come"
    def get(self, name: str, *params: float) -> tuple:
        "As `ask`; when that brings nothing, the older request for all is tried, as clients do"
    def get_all(self, name: str, count: str, *params: float) -> list:
        "What a request for all brings; each message tells in its field `count` how many there are"
    @property
    def others(self) -> dict:
        "All components that were heard: `{(system, component): MAV_TYPE, or None without a heartbeat}`"
    @property
    def cameras(self) -> list:
        "Addresses of the components that may be cameras"
    def find(self, timeout: float = 10.0) -> bool:
        "Wait for the camera, and ask it what it is; is it there? Raises `ValueError` when there are several"
    def has(self, flag: str) -> bool:
        "Does the camera claim `flag`, such as 'CAPTURE_IMAGE'?"
    def check_flags(self, r: Requirement) -> None:
        "Raise `NotForThis` unless `r` is for a camera with these flags"
    def is_there(self, silence: float = 6.0) -> bool:
        "Was the camera heard in the last `silence` s? If not, it gets a moment more; a third time it gets none"
    def floods(self) -> bool:
        "Does the camera send more frames than we keep? A flood that ends within a moment is forgiven"
    def check_manners(self, r: Requirement, destroy: bool) -> None:
        "Raise `Untested` when `r` must not be looked at here"
    def put_on(self, role: str) -> None:
        "Play `role`, and give the link its quality"
    def judge(self, r: Requirement, destroy: bool = False) -> Row:
        """Put the camera to one requirement; raises `LinkError` when the link has gone

        Args:
            destroy: Are checks allowed that delete or reset?
        """
    def verdict(self, name: str) -> str:
        "The verdict on a requirement, which may also destroy; it is looked at twice unless it is met"
    def judge_all(self, only: Any = ..., destroy: bool = False) -> list:
        "A row for each chosen requirement"
    def status(self) -> Any:
        "CAMERA_CAPTURE_STATUS now; raises `Untested`"
    def idle(self, timeout: float = 8.0) -> None:
        "End what the camera is taking, and wait until it has ended"
    def mode_now(self) -> int | None:
        "The mode in CAMERA_SETTINGS; `None` when it has no modes"
    @contextmanager
    def ready(self, mode: str) -> Generator[Any, None, None]:
        """For `with`: the camera is idle and in this mode; it gets its old mode back. Raises `Untested`

        Args:
            mode: 'image' or 'video'
        """
    def next_number(self) -> int:
        "A new sequence number, for parameter 4 of IMAGE_START_CAPTURE"
    def notices(self, since: int, wanted: int = 0, timeout: float = 10.0) -> list:
        "The CAMERA_IMAGE_CAPTURED since then; waits for as many as `wanted`, then until it is clear that no more come"
    def shot(self, send: Any, wanted: int = 1) -> Shot:
        "What comes of `send`, which gives `Acks`"
    def take(self, *params: float, wanted: int = 1) -> Shot:
        "Take one picture, or as the parameters say; raises `Untested` when it is not accepted"
    def ftp_send(self, packet: FtpPacket, size: int | None = None) -> int:
        "Send one packet; the place in the record before any answer"
    def ftp_replies(self, since: int) -> list:
        "The packets of the camera since then"
    def ftp_reply(self, since: int, asked: int, seq: int | None = None, timeout: float | None = None) -> FtpPacket | None:
        "The reply to a request, or `None`"
    def ftp(
            self, opcode: int, data: bytes = b'', session: int = 0, offset: int = 0, size: int | None = None,
    ) -> FtpPacket | None:
        """One operation: its reply, or `None`. Repeated as it is when our role has a bad radio

        Args:
            size: Bytes that are wanted
        """
    def ftp_open(self, path: str) -> tuple:
        "`(session, size)` of a file; raises `Untested` when it cannot be opened"
    def ftp_read(self, session: int, size: int, piece: int = 239) -> bytes:
        "A file that is open, in pieces; raises `Untested` when one does not come"
    def ftp_fetch(self, path: str, pieces: int = 1) -> bytes:
        "What is in a file, in so many pieces at least; raises `Untested`"
    @property
    def definition_uri(self) -> str:
        "Where the definition is; raises `NotForThis` when there is none"
    def definition_bytes(self) -> bytes:
        "The definition file as it comes, fetched once; raises `Untested` and `NotForThis`"
    def definition(self) -> Any:
        "The definition; raises `Untested` and `NotForThis`"
    def streamed(self, period: float, seconds: float = 2.0, stop: bool = True) -> tuple:
        "`(answer, how many came)` of CAMERA_CAPTURE_STATUS every `period` µs"
    def stop_stream(self) -> None:
        "No more CAMERA_CAPTURE_STATUS; said again when a camera does not hear it in its own noise"
    @contextmanager
    def lens_restored(self, command: str, field: str) -> Generator[Any, None, None]:
        "For `with`: gives the level in CAMERA_SETTINGS, and puts it back. Raises `Untested`"
    @contextmanager
    def clear(self) -> Generator[Any, None, None]:
        "For `with`: nothing is lost, as long as we look at what became of it"
    def list_params(self) -> dict:
        "`{name: ParamExt}` of all, listed once; raises `Untested` and `NotForThis`"
    def read_param(self, name: str = '', index: int = -1) -> ParamExt | None:
        "One parameter by name or index; `None` when it does not come"
    def set_param(self, name: str, kind: int, raw: bytes) -> ParamExt | None:
        "Set one: the final PARAM_EXT_ACK, or `None`"
    @contextmanager
    def changed_param(self) -> Generator[Any, None, None]:
        "For `with`: set one to another value, and back; `(parameter, value, ack, place in the record)`, or `NotForThis`"
    def ping(self, *to: int, timeout: float | None = None) -> tuple:
        "`(what we sent, the first PING with its time, or None)`; it is for all, or for the address `to`"
    @contextmanager
    def recording(self, rate: float = 0.0) -> Generator[Any, None, None]:
        "For `with`: the camera records; gives the `Acks`. Raises `Untested`"
    def describe(self) -> dict:
        "What the camera says it is"
    def run_suite(self, only: Any = ..., destroy: bool = False, tell: Any = None, connection: str = '') -> Findings:
        """Put the camera to all that is chosen; raises `LinkError` when the link has gone

        Args:
            only: As for `suite`
            destroy: Are checks allowed that delete or reset?
            tell: Called with each requirement before it is looked at, and with each `Row`
            connection: For the report
        """

class Acks:
    "What came of a command"
    command: int
    sent: float
    since: int
    acks: list
    result: Any
    after: Any
    name: str
    def __init__(self, command: int, sent: float, since: int, acks: list) -> None: ...
    def __bool__(self) -> bool: ...
    @property
    def refused(self) -> bool:
        "Is it UNSUPPORTED or DENIED?"
message_ids: dict
older: dict

__all__ = ['message_ids', 'older', 'Prober', 'Acks']
