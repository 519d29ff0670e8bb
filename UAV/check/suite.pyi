"Run all requirements, or those that you choose, on one camera, in the right order."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any

subjects: dict
def suite(only: Any = ...) -> list:
    """The requirements in order; raises `ValueError` for an unknown name

    Args:
        only: Names such as 'photo.notice', or subjects such as 'photo'; none: all
    """

@dataclass
class Findings:
    "What a camera is, and what came of each requirement"
    camera: dict
    connection: str = ...
    when: float = ...
    seconds: float = ...
    rows: list = ...
    @property
    def counts(self) -> dict:
        "`{verdict: how many}`"
    @property
    def failed(self) -> list:
        "The rows that failed"
    @property
    def exit_code(self) -> int:
        "1 when a requirement is not met, else 0"
def cost(found: list, destroy: bool = False) -> str:
    """What it leaves behind, as a sentence

    Args:
        found: Requirements
        destroy: Are those allowed that delete or reset?
    """

__all__ = ['subjects', 'suite', 'Findings', 'cost']
