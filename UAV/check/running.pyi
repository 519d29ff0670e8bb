"Read the options, find the camera, run the suite, show what was found, and end with an exit code."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.check.prober import Prober
from UAV.check.suite import Findings
from argparse import ArgumentParser
from typing import Any

def check_seconds(text: str) -> Any: ...
def check_options(
        connection: str = 'udpin:0.0.0.0:14550', target: str | None = None, only: str | None = None,
        list: bool = False, destructive: bool = False, html: str | None = None, json: bool = False,
        timeout: Any = 10.0, patience: Any = 3.0,
) -> Any:
    """What can be typed

    Args:
        connection: MAVLink link to the camera
        target: SYSTEM/COMPONENT of the camera, such as 1/100; needed when there are several
        only: Requirements or subjects, with commas between them, such as photo,storage.ids
        list: Say what would be looked at, and end
        destructive: Also format the storage and reset the settings
        html: File for a report that you can print
        json: Print the report as JSON
        timeout: s to look for the camera
        patience: s in which an answer must come; more for a slow radio
    """
check_about: str
check_below: str
def check_parser() -> ArgumentParser:
    "The parser of `uav-camera-check`"
def as_address(text: str | None) -> tuple | None:
    "`(system, component)` in '1/100'; raises `ValueError`"

class Shower:
    "Shows rows as they come, and on a terminal what is looked at"
    count: int
    quiet: bool
    n: int
    subject: Any
    live: Any
    def __init__(self, count: int, quiet: bool = False) -> None: ...
    def __call__(self, what: Any) -> Any: ...
def heard_lines(p: Prober) -> list:
    "Who is on the link"
def no_camera(p: Prober, typed: Any) -> int:
    "Say that there is none; the exit code"
def list_suite(found: list, typed: Any) -> int:
    "Say what would be looked at; the exit code"
def tell(found: Findings, typed: Any) -> int:
    "Say what was found; the exit code"
def check_camera(typed: Any) -> int:
    "Do what was typed; the exit code. Raises `ValueError`, `OSError` and `LinkError`"
def check_main(words: list) -> int:
    """The program; its exit code. Raises `KeyboardInterrupt`

    Args:
        words: Of the command line
    """

__all__ = [
    'check_seconds', 'check_about', 'check_below', 'check_options', 'check_parser', 'as_address', 'Shower',
    'heard_lines', 'no_camera', 'list_suite', 'tell', 'check_camera', 'check_main',
]
