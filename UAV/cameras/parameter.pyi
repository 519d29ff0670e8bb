"One setting of a camera, declared as data: its name, its type, the values that it may have, and the settings that change with it."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.values import Value
from dataclasses import dataclass
from typing import Any

def as_float32(value: float) -> float:
    "The shortest decimal number that is the same float32; raises `OverflowError` when it is too large for one"
kinds: tuple
def typed(kind: str, value: Any, what: str = 'it') -> Any:
    """`value` in its type; raises `ValueError` when it does not fit

    Args:
        kind: One of `kinds`
        value: A number; text or bytes for 'custom'
        what: What the error speaks of
    """

class Declared(Value):
    "Base of the two dataclasses below: shows what is not as usual"
def names_in(what: str, names: Any) -> tuple:
    "`names`; raises `ValueError` unless they are a list of names"

@dataclass(frozen=True, repr=False, eq=False)
class Option(Declared):
    "One of the values that a parameter may have"
    name: str
    value: Any
    exclusions: tuple = ...
    ranges: dict = ...

@dataclass(frozen=True, repr=False, eq=False)
class Parameter(Declared):
    "What a camera declares of one setting"
    name: str
    kind: str = ...
    default: Any = ...
    description: str = ...
    options: tuple | dict = ...
    low: float | None = ...
    high: float | None = ...
    step: float | None = ...
    unit: str = ...
    updates: tuple = ...
    control: bool = ...
    readonly: bool = ...
    writeonly: bool = ...
    def check(self, value: Any) -> Any:
        """`value` in the parameter's type; raises `ValueError` with a sentence when the parameter cannot be that

        Args:
            value: A number, or the name of an option
        """
    def text(self, value: Any) -> str:
        """`value` for people

        Args:
            value: That `check` gave
        """
    def what(self) -> str:
        "Which values there are, in a few words"

class UnknownParameter(ValueError):
    "The camera has no parameter of that name"
    @classmethod
    def among(cls, names: Any, name: Any) -> Any:
        """The error for a name that is none of `names`

        Args:
            names: Those that there are
            name: What was asked for
        """
def declarations(declared: Any) -> list:
    """`declared` as a list; raises `ValueError` when it is not one of `Parameter`s

    Args:
        declared: `Parameter`s
    """

@dataclass(frozen=True, repr=False, eq=False)
class ParametersChanged(Value):
    "Parameters have new values"
    values: dict

__all__ = [
    'kinds', 'as_float32', 'typed', 'Declared', 'names_in', 'Option', 'Parameter', 'UnknownParameter', 'declarations',
    'ParametersChanged',
]
