"Say each result as a sentence for people, or with `--json` as one JSON object a line."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals.values import GimbalAttitude
from typing import Any


class Reporter:
    "Says what happened: as a sentence, or as an object"
    as_json: bool
    out: Any
    def __init__(self, as_json: bool = False, out: Any = None) -> None:
        """
        Args:
            as_json: Objects?
            out: Where to; `None`: standard output
        """
    def say(self, sentence: str, **fields: Any) -> None:
        """One line

        Args:
            sentence: For people
            fields: The same for programs
        """
def attitude_text(attitude: GimbalAttitude | None) -> str:
    """Where it points, for people

    Args:
        attitude: `None`: it did not tell
    """
def attitude_object(attitude: GimbalAttitude | None) -> dict:
    """Where it points, for programs: degrees; nothing when it did not tell

    Args:
        attitude: `None`: it did not tell
    """
exit_codes: str
disk_errors: tuple
results: list
def ending(error: Exception) -> tuple:
    """`(exit code, sentence)`

    Args:
        error: What was raised
    """

__all__ = ['exit_codes', 'disk_errors', 'results', 'Reporter', 'attitude_text', 'attitude_object', 'ending']
