"What `uav-gimbal` and `uav-camera` have in common: open the links, find the device, do one thing, say how it went, and end."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

def number(text: str) -> Any: ...
def seconds(text: str) -> Any: ...
us: tuple

class Visitor:
    "For a client that is there for a moment, again and again"
    def on_mav_connection(self) -> None:
        "Number our frames"
@contextmanager
def on_links(options: Any) -> Generator[Any, None, None]:
    "For `with`: the links that were typed; gives their `MAVCom`"

class Visit:
    "A device, and what was typed about it; subclasses know what kind of device it is"
    program: str
    kind: str
    choices: str
    listen: float
    client: Any
    options: Any
    reporter: Any
    verb: str
    endless: bool
    def __init__(self, client: Any, options: Any, reporter: Any = None, verb: str = '') -> None:
        """
        Args:
            client: A component that is on the links
            options: Has the `options` as attributes
            reporter: Says what happened, as `Reporter` does
            verb: That was typed
        """
    async def look(self, count: int | None, seconds: float) -> list:
        "The devices that are heard in so many `seconds`; fewer seconds when `count` is given, and reached"
    def is_meant(self, device: Any) -> bool:
        "Is this the device that was typed?"
    async def find(self) -> list:
        "The devices that were meant; none when there is none in time"
    def called(self, device: Any) -> str:
        "What tells a device from another"
    def sought(self) -> str:
        "What is looked for"
    def only(self, meant: list) -> Any:
        """The one device that was meant; raises `NoAnswer` for none, and `ValueError` for several

        Args:
            meant: As `find` gives them
        """
    def take(self, device: Any) -> None:
        "All verbs are for this device"
    async def choose(self) -> Any:
        "Make the device that was meant the client's target, and return it; raises as `find` and `only`"
    def heard(self) -> dict:
        "`{link: names of the components that were heard there}`"
    def fail(self, error: Exception, advice: str = '', **fields: Any) -> int:
        """Say what went wrong; the exit code

        Args:
            error: What a verb raised
            advice: What else to say about a refusal
            fields: The same for programs
        """

class Program:
    "A program whose verbs visit a device"
    about: str
    options: Any
    visit: Any
    client: Any
    verbs: dict
    there: Any
    def __init__(self, about: str, options: Any, visit: Any, client: Any) -> None:
        """
        Args:
            about: What it does
            options: A function: its parameters are the options that all verbs have
            visit: A class such as `Visit`
            client: A class that is a `Visitor`
        """
    def verb(self, *examples: Any) -> Any:
        """Make a function a verb of the program

        Args:
            examples: Of what to type
        """
    async def run(self, typed: Any) -> int:
        """Do what was typed; the exit code

        Args:
            typed: Has the verb, its words and the options as attributes
        """
    def main(self, words: list) -> int:
        """The program; its exit code. Raises `KeyboardInterrupt`

        Args:
            words: Of the command line
        """

__all__ = ['number', 'seconds', 'us', 'Visitor', 'on_links', 'Visit', 'Program']
