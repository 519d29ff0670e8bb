"Ground stations list a camera's settings, set one, and hear of each change."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Pending:
    "Parameters that are being set, and what is wanted of each"
    def __init__(self) -> None: ...
    def __contains__(self, name: Any) -> bool: ...
    def want(self, name: str, value: Any) -> bool:
        "Note that `name` shall be `value`; was nothing wanted of it before?"
    def wanted(self, name: str) -> Any:
        "What is wanted of `name`; `None`: nothing"
    def done(self, name: str, value: Any) -> bool:
        "It is `value`, or cannot be; is that all that was wanted?"
definition_path: str

__all__ = ['definition_path', 'Pending']
