"`GimbalRow` keeps what the panel shows of one gimbal: where it points, who is in control, and how it was held when a picture was taken."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import GimbalAttitude
from UAV.manager.geometry import History
from UAV.manager.helm import Helm
from UAV.manager.rows import Row
from UAV.wire.dialect import Ack
from typing import Any


class GimbalRow(Row):
    "One gimbal: what it has told, and its helm"
    kind: str
    patience: float
    gimbal: tuple
    client: Any
    helm: Helm
    remote: Any
    missing: str
    history: History
    frame: Any
    def __init__(self, gui: Any, gimbal: tuple) -> None:
        """
        Args:
            gui: The `Gui`; its `gimbal_client` is on a link
            gimbal: `(system, component, gimbal_device_id)`
        """
    async def close(self) -> None:
        "Turn no more, and give back the control that we took"
    @property
    def lost(self) -> str:
        "Why the gimbal is lost; empty when it is not"
    def note(self, now: GimbalAttitude) -> None:
        """Keep an attitude

        Args:
            now: That has just come
        """
    async def learn(self) -> None:
        "Have the gimbal tell what it is and where it points; what is missing is noted. Raises `MAVError` when it is silent"
    async def listen(self) -> None:
        "Note its attitudes, until none comes for a while; raises `Lost`"
    def forget(self) -> None:
        "Forget what was heard of the gimbal"
    async def run(self) -> None:
        "Learn and listen, anew whenever the gimbal falls silent; until cancelled"
    def limits(self) -> dict:
        "How far pitch and yaw go, degrees; `None`: there is no such axis, or it does not say"
    def pointing(self) -> dict:
        "Where it points; degrees, `heading` from north"
    def owner(self) -> dict:
        "Who is in control, and is it us?"
    def status(self) -> dict:
        "All that a viewer shows of it, as plain values"
    async def hold(self, pitch: float, yaw: float, hold: str, n: int) -> None:
        """A button is held, still: turn. It ends by itself when this is not said again

        Args:
            pitch, yaw: Degrees a second
            hold: The same for as long as the button is down, and then never again
            n: Counts the words about it
        """
    async def release(self, hold: str) -> None:
        """The button was let go: turn no more

        Args:
            hold: As for `hold`
        """
    async def ready(self) -> None:
        "What comes before each move: turn no more, and be in control. Raises `Denied` when another is, and `MAVError`"
    async def attitude(self, pitch: float, yaw: float) -> Ack:
        """Point there

        Args:
            pitch, yaw: Degrees, yaw from the nose
        """
    async def down(self) -> Ack:
        "Look straight down; yaw stays"
    async def center(self) -> Ack:
        "Look straight ahead"
    async def retract(self) -> Ack:
        "Fold away"
    async def sees(self, test: Any, seconds: float = 1.0) -> None:
        """Wait until what the gimbal tells passes a test

        Args:
            test: Called with nothing
            seconds: To wait at most
        """
    async def lock(self) -> Ack:
        "Hold the direction on earth, however the vehicle turns"
    async def follow(self) -> Ack:
        "Let yaw follow the nose"
    async def take(self) -> str:
        "Take control, from another client as well"
    async def give(self) -> str:
        "Give control back, if it is ours"
    async def aim_at(self, pitch: float, yaw: float) -> Any:
        """Point there, and leave the lock as it is

        Args:
            pitch, yaw: Degrees, yaw in the `frame` of the history
        """
    def beyond(self, pitch: float, yaw: float) -> str:
        "A word about a direction that the gimbal cannot reach"

__all__ = ['GimbalRow']
