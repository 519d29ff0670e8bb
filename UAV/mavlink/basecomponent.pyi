"The base of every camera, gimbal and ground station on a link: an address, a heartbeat, and a way for each message that arrives."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging
from UAV.mavlink.asking import Commands
from UAV.mavlink.finding import TimeSync
from UAV.mavlink.handlers import Outcome, Served, Tables
from UAV.mavlink.mavcom import MAVCom
from UAV.mavlink.protocol import Expectations
from UAV.mavlink.sender import Sender
from UAV.utils.general import Worker
from UAV.wire.dialect import Ack
from typing import Any


class Counts:
    "What a component has received, sent and missed"
    message_cnts: dict
    num_msgs_rcvd: int
    num_cmds_rcvd: int
    num_acks_rcvd: int
    num_cmds_sent: int
    num_acks_sent: int
    num_acks_drop: int
    def __init__(self) -> None: ...

class BaseComponent:
    "One component of a MAVLink system"
    message_cnts: dict
    num_msgs_rcvd: int
    num_cmds_rcvd: int
    num_acks_rcvd: int
    num_cmds_sent: int
    num_acks_sent: int
    num_acks_drop: int
    autopilot: int
    base_mode: int
    results: dict
    in_progress_after: float
    command_timeout: Any
    patience: float
    source_component: int
    mav_type: int
    log: logging.Logger
    counts: Counts
    tables: Tables
    sender: Sender
    worker: Worker
    served: Served
    under_way: dict
    mav_com: MAVCom | Any
    asking: Commands | Any
    expectations: Expectations
    def __init__(self, source_component: int, mav_type: int, loglevel: int = ...) -> None:
        """
        Args:
            source_component: Our component id (MAV_COMP_ID), 1 to 255
            mav_type: What we are (MAV_TYPE), for the heartbeat
        """
    def on_mav_connection(self) -> Any:
        "Called when we are on a link; for subclasses"
    def on_message(self, msg: Any) -> Any:
        "Called with every message for us; for subclasses: true for a command means accepted"
    @property
    def system_status(self) -> Any:
        "MAV_STATE of our heartbeat"
    @system_status.setter
    def system_status(self, value: Any) -> None: ...
    @property
    def source_system(self) -> int | None:
        "Our system id, once we are on a link"
    @property
    def mav(self) -> Any:
        "Our encoder, once we are on a link"
    @property
    def commands(self) -> dict:
        "The commands that we answer: `{MAV_CMD: Handler}`"
    @property
    def remotes(self) -> dict:
        "What is known of the components on our link; raises `LinkError` when we are on none"
    @property
    def round_trips(self) -> dict:
        "Seconds to `(system, component)` and back, of those that have answered; raises `LinkError` when we are on no link"
    def set_log(self, loglevel: int) -> None:
        "Change how much this component logs"
    def send_message(self, msg: Any, to: tuple | None = None) -> None:
        """Send a message as ours; raises `LinkError` when we are on no link, `ValueError` when a field does not fit

        Args:
            msg: As our encoder `mav` makes it
            to: `(system, component)` that gets it; `None`: its target, and all when it has none
        """
    def encode_heartbeat(self) -> Any:
        "Our HEARTBEAT"
    def beat(self) -> None:
        "Send our heartbeat"
    def set_source_component(self) -> None:
        "Make the encoder that marks our messages with our ids"
    def set_source_compenent(self) -> None:
        "Make the encoder that marks our messages with our ids"
    def set_mav_connection(self, mav_com: MAVCom) -> None:
        "Join the link of `mav_com`; raises `LinkError` when we have left another"
    def lose(self, source: tuple, why: str) -> None:
        "`source` has fallen silent: what waits for it ends, with the reason"
    def close(self) -> None:
        "Leave the link; safe to call twice"
    def deliver(self, msg: Any) -> None:
        "Take a message that arrived for us; called by the link's reader"
    def count_message(self, msg: Any) -> None:
        "Count `msg` in `message_cnts[system][MESSAGE_NAME]`"
    def show(self, msg: Any) -> bool:
        "Show `msg` to `on_message` and the callbacks; true when one of them says so"
    def append_message_handler(self, callback: Any) -> None:
        """Call `callback(msg)` for messages that arrive; a true value for a command means accepted

        Args:
            callback: Called with each message for us, on the reader thread: be quick
        """
    def expecting(self, msg_id: int, fits: Any = ..., source: tuple | None = None) -> Any:
        """For a `with`: the next message of a kind; `await` its `wait(timeout)` there

        Args:
            msg_id: MAVLINK_MSG_ID
            fits: A test that the right message passes
            source: `(system, component)`: stop waiting when this one falls silent
        """
    def result_of(self, error: BaseException, what: str) -> int:
        "The MAV_RESULT for an `error` that `what` raised"
    def run_command(self, handler: Any, msg: Any) -> Outcome:
        "Call `handler` with the parameters of `msg`"
    def send_ack(self, msg: Any, ack_result: int = ..., progress: int = 0, value: int = 0) -> None:
        """Answer a command with a COMMAND_ACK to its sender

        Args:
            msg: The command
            ack_result: A MAV_RESULT
            progress: %; 255: not known
            value: `result_param2`: its meaning depends on the command
        """
    def answer_command(self, handler: Any, msg: Any) -> None:
        "Run `handler`, send its ack, then what it brought about"
    def on_command(self, msg: Any) -> Any:
        "Answer a command"
    def on_command_cancel(self, msg: Any) -> None:
        "Take back a slow command of the same sender (COMMAND_CANCEL)"
    def is_cancelled(self, command_id: int) -> bool:
        """Has the sender of the slow command that is under way taken it back?

        Args:
            command_id: A MAV_CMD
        """
    async def send_command(
            self, target_system: int, target_component: int, command_id: int, params: Any = ...,
            timeout: float | None = None, retries: int | None = None, frame: int | None = None, until: Any = None,
    ) -> Ack:
        """Send a command and wait for its `Ack`, which is true when accepted; raises `LinkError` when we are on no link

        Args:
            target_system: 0: all systems
            target_component: 0: all components
            command_id: A MAV_CMD
            params: Up to seven numbers; NaN for "not given"
            timeout: Seconds until each next copy; `None`: as the round trips demand
            retries: How often to send it again; `None`: for `patience`, twice to one never heard
            frame: Send a COMMAND_INT in this MAV_FRAME, and not a COMMAND_LONG
            until: An `Expected` message that makes the ack unnecessary
        """
    def on_ping(self, msg: Any) -> Any:
        "Answer a PING, or take the answer to ours"
    def on_timesync(self, msg: Any) -> None:
        "Answer a TIMESYNC with our clock, ns since 1970; or take the answer to ours"
    def cancel_command(self, target_system: int, target_component: int, command_id: int) -> None:
        "Take back a command that is under way: its ack will be CANCELLED, or the result if it was too late"
    async def wait_ack(
            self, target_system: int, target_component: int, command_id: int | None = None, timeout: float = 0.1,
    ) -> bool:
        """Wait for an ack without sending anything; true when it says accepted

        Args:
            target_system: 0: any
            target_component: 0: any
            command_id: A MAV_CMD; `None`: any
            timeout: Seconds
        """
    async def wait_heartbeat(
            self, remote_mav_type: int | None = None, target_system: int | None = None,
            target_component: int | None = None, timeout: float = 1.0,
    ) -> tuple | None:
        """`(system, component)` of the first that beats, or `None`

        Args:
            remote_mav_type: Only this MAV_TYPE
            target_system: Only this system
            target_component: Only this component
            timeout: Seconds
        """
    def send_ping(self, target_system: int = 0, target_component: int = 0, ping_num: int | None = None) -> None:
        "Measure round trips: the answers go to `round_trips`. MAVLink's PING is always for all, so the target is not sent"
    async def timesync(
            self, target_system: int, target_component: int, count: int = 5, timeout: float = 0.5,
    ) -> TimeSync | None:
        """Compare clocks with a component; `None` when it does not answer, raises `Lost` when it falls silent

        Args:
            count: How often to ask: the fastest answer is the best
            timeout: Seconds to wait for each answer
        """
    async def test_command(self, target_system: int, target_component: int, camera_id: int = 0) -> Ack:
        "Trigger a camera with MAV_CMD_DO_DIGICAM_CONTROL; `camera_id` goes into the command identity"

__all__ = ['Counts', 'BaseComponent']
