"`doc_class` lists all public methods of a class in one cell, wherever they were written."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass
from typing import Any


class ClassDoc:
    "The public methods of a class, as Markdown in a notebook and as text elsewhere"
    name: Any
    doc: Any
    methods: list
    def __init__(self, cls: Any) -> None: ...
def doc_class(cls: Any) -> ClassDoc:
    "The documentation of all public methods of `cls`, in one cell; `TypeError` when it is no class"
def takes_options(options: Any) -> Any:
    """For a function with `**kwargs` that are fields of `options`: signature and documentation show them

    Args:
        options: A dataclass
    """

__all__ = ['ClassDoc', 'doc_class', 'takes_options']
