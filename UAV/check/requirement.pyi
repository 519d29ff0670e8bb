"Write a requirement as a marked function: its name, its sentence, where it is written, and what the check costs."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any, Callable, TypeVar
_T = TypeVar('_T')


class NotMet(Exception):
    "The camera does something else; the text says what was seen"

class Untested(Exception):
    "It cannot be told; the text says why"

class NotForThis(Exception):
    "The requirement is not for this camera; the text says why"
verdicts: dict
def must(holds: _T, seen: str) -> _T:
    """`holds`, when it does; raises `NotMet`

    Args:
        holds: What the requirement demands
        seen: What was seen instead
    """
def given(holds: _T, why: str) -> _T:
    """`holds`, when it does; raises `Untested`

    Args:
        holds: What is needed before a look is worth while
        why: What is missing
    """

@dataclass(frozen=True)
class Role:
    "Who the camera is talking to"
    name: str
    system: int | None
    component: int
    kind: int
    unused: float = ...
    loss: float = ...
roles: dict

@dataclass(frozen=True)
class Requirement:
    "One thing that a camera must do"
    name: str
    sentence: str
    source: str
    check: Callable
    role: str = ...
    needs: str = ...
    lacks: str = ...
    pictures: int = ...
    recordings: int = ...
    destroys: bool = ...
    @property
    def subject(self) -> str:
        "The part of the name before the dot"
all_requirements: dict
def requirement(name: str, sentence: str, source: str, **options: Any) -> Any:
    """Make a function the check of a requirement

    Args:
        name: Such as 'photo.notice'
        sentence: What must hold
        source: Where it is written
        options: As for `Requirement`
    """

__all__ = [
    'verdicts', 'roles', 'all_requirements', 'NotMet', 'Untested', 'NotForThis', 'must', 'given', 'Role',
    'Requirement', 'requirement',
]
