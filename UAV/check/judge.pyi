"Run one check on one camera and get a verdict, with what was seen: passed, failed, does not apply, or could not be tested."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.check.prober import Prober
from UAV.check.requirement import Requirement
from dataclasses import dataclass
from typing import Any

marks: dict

@dataclass(frozen=True)
class Row:
    "What came of one requirement"
    requirement: Requirement
    verdict: str
    seen: str
def chosen(only: Any = ...) -> list:
    """The requirements that were chosen, in order; raises `ValueError` for an unknown name

    Args:
        only: Names such as 'photo.notice', or subjects such as 'photo'; none: all
    """
def must_bring(p: Prober, command: str, name: str) -> str:
    """What an older request command brought: its ack and its message must come. Raises `NotMet`

    Args:
        command: Such as 'REQUEST_CAMERA_SETTINGS'
        name: Of the message that it brings
    """

__all__ = ['marks', 'Row', 'chosen', 'must_bring']
