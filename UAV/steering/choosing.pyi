"Find the gimbals, choose the one that you mean, and say what was heard when it is not there."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.steering.visit import Visit
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager
from typing import Any


class Steering(Visit):
    "A gimbal, and what was typed about it"
    program: str
    kind: str
    choices: str
    patience: float
    effect: float
    async def look(self, count: int | None, seconds: float) -> list:
        "The gimbals that are heard"
    def is_meant(self, gimbal: Any) -> bool:
        "Is this the gimbal that was typed?"
    def called(self, gimbal: Any) -> str:
        "What tells a gimbal from another"
    def sought(self) -> str:
        "What is looked for"
    def take(self, gimbal: Any) -> None:
        "All verbs are for this gimbal"
    @property
    def owner(self) -> str | None:
        "Who is in control, such as '255/190'; `None` when there is none"
    @asynccontextmanager
    def acting(self) -> AsyncGenerator[Any, None]:
        "For `async with`: in control of the gimbal that was meant; gives the client. Raises `Denied` when another has it"
    async def newest(self) -> Any:
        "Where the gimbal points, when what it was told has had an effect; `None` when it does not tell within a second"
    async def tell(self, text: str = '', **fields: Any) -> None:
        """Say where the gimbal points

        Args:
            text: What went well, before where it points
            fields: The same for programs
        """
    async def act(self, name: str, *args: Any) -> None:
        "Take control, call one verb of the client, and tell where that led; raises what `Ack.check` raises"
    def fail(self, error: Exception) -> int:
        """Say what went wrong, and who is in control; the exit code

        Args:
            error: What a verb raised
        """

__all__ = ['Steering']
