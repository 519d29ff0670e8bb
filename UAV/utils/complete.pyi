"A last step for an object, after the constructors of all its classes."
# Written by .ci/stubs.py from the live classes: do not edit.
from abc import ABCMeta
from typing import Any


class CompleteLater(ABCMeta):
    "Makes classes whose objects hear by `_complete` that they are complete; a forgotten constructor is a `TypeError`"
    def __call__(cls, *args: Any, **kwargs: Any) -> Any: ...

__all__ = ['CompleteLater']
