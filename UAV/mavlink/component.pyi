"Ask any component for a message, once or as a stream, and answer such requests with marked methods."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.logging import LogLevels as LogLevels
from UAV.mavlink.basecomponent import BaseComponent
from UAV.mavlink.streams import Streams
from UAV.wire.dialect import Ack
from pymavlink import mavutil as mavutil
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from pymavlink.dialects.v20.ardupilotmega import MAVLink as MAVLink
from typing import Any


class Component(BaseComponent):
    "A component that sends messages on request, and asks others for theirs"
    min_interval: int
    pace: float
    sending: Streams
    target_system: int | Any
    target_component: int | Any
    def __init__(self, source_component: int, mav_type: int, loglevel: int = ...) -> None:
        """
        Args:
            source_component: Our component id (MAV_COMP_ID)
            mav_type: What we are (MAV_TYPE)
        """
    def beat(self) -> None:
        "Send our heartbeat, and see which of those we stream to are still there"
    def close(self) -> None:
        "Stop all streams and leave the link"
    @property
    def messages(self) -> dict:
        "The messages that we send on request: `{message id: Handler}`"
    def encode_requested(self, msg_id: int, values: Any = ..., msg: Any = None) -> Any:
        "The messages that a request `msg` for `msg_id`, with parameters `values`, is answered with; raises `Unsupported`"
    def send_requested(self, msg_id: int, values: Any, msg: Any, to_all: bool = False) -> None:
        "Answer the request `msg` with message `msg_id`; raises `Busy` when its sender has a long answer under way"
    def set_target(self, target_system: int, target_component: int) -> None:
        "Whom the verbs below address when they are not told"
    def target(self, target_system: int | None = None, target_component: int | None = None) -> tuple:
        "`(system, component)` to address; raises `MAVError` when there is none"
    def rto(self, target: tuple) -> float:
        "Seconds in which an answer of `target` should be here"
    def warn_unheard(self, msg_id: int, ack: Ack) -> None:
        "Log who was heard, when `ack` says that its target never was"
    async def request_message(
            self, msg_id: int, params: Any = None, target_system: int | None = None, target_component: int | None = None,
            timeout: float | None = None, fits: Any = None,
    ) -> Any:
        """Ask for a message with MAV_CMD_REQUEST_MESSAGE; the message, or `None`

        Args:
            msg_id: Which message (MAVLINK_MSG_ID)
            params: Parameters 2 to 6 of the request; 0 when left out
            timeout: Seconds to wait for the message after each ack; `None`: half a second, or two time-outs
            fits: A test for the right message, where there are several of a kind
        """
    def start_stream(
            self, msg_id: int, interval: float, *values: Any, asker: tuple | None = None, to_all: bool = False,
    ) -> None:
        """Send a message again and again; raises `Unsupported`, `Denied` for a long one, `Busy` for too many

        Args:
            msg_id: Which message
            interval: µs, at least `min_interval`
            values: Parameters of the request, such as an index
            asker: `(system, component)` that it is for; `None`: all, until `stop_stream`
            to_all: Whether all hear what `asker` asked for
        """
    def stop_stream(self, msg_id: int, *values: Any, asker: tuple | None = None) -> None:
        "Stop what `asker` gets of `msg_id`, if anything; a long answer, too"
    async def request_message_stream(
            self, target_system: int | None = None, target_component: int | None = None, msg_id: int = ...,
            interval: float = 1000000, response_target: int = 0,
    ) -> Any:
        """Ask for a stream of messages; the first one, or `None`

        Args:
            msg_id: Which message
            interval: µs; -1 stops the stream
            response_target: Parameter 7 of MAV_CMD_SET_MESSAGE_INTERVAL
        """
    def set_message_callback_cond(
            self, msg_id: int, target_system: int | None = None, target_component: int | None = None,
    ) -> Any:
        "A condition that is met by the next message `msg_id` from this sender; `None` and 0 fit any"
    async def wait_message_callback(self, cond: Any, timeout: float = 1, remove_after: bool = True) -> Any:
        "The message that met `cond`, or `None`; with `remove_after=False` it can be waited for again"
    async def message_callback_cond(
            self, msg_id: int, target_system: int | None = None, target_component: int | None = None, timeout: float = 1,
    ) -> Any:
        "The next message `msg_id` from this sender, or `None`"
    def list_commands(self) -> None:
        "Print the commands this component answers and the messages it sends on request, under names that code can use"
    def say(self, severity: int, text: str) -> None:
        """Tell the people at the ground stations: STATUSTEXT, in as many pieces as it takes

        Args:
            severity: MAV_SEVERITY
            text: At most 200 bytes are sent
        """
    def list_verbs(self) -> None:
        "Print the verbs of this client, and the command that each one sends"
everyone: int
def message_name(msg_id: int) -> str:
    "The dialect's name of a message; its number when it has none"

__all__ = ['everyone', 'Component', 'message_name', 'MAVLink', 'mavlink', 'LogLevels']
