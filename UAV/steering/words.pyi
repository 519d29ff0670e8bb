"Make a program with verbs: a function becomes a verb, its parameters words and options, its docstring the help."
# Written by .ci/stubs.py from the live classes: do not edit.
from argparse import ArgumentParser
from typing import Any

def between(low: float, high: float, kind: Any = ..., nan: bool = False) -> Any:
    """A type for `argparse`: a number from `low` to `high`

    Args:
        low, high: What is allowed
        kind: Or `int`
        nan: Is nan a number, too?
    """
def words_of(function: Any) -> dict:
    """What can be typed for `function`: `{name: its annotation, default and comment}`

    Args:
        function: With a comment for each parameter
    """
def add_words(parser: Any, function: Any, **how: Any) -> None:
    """Have the words and options of `function` typed

    Args:
        parser: An `ArgumentParser`, or a group of one
        function: As for `words_of`
        how: For each option: `default=SUPPRESS` leaves the default to another parser
    """
def shielded(typed: list) -> list:
    """The same words; negative numbers cannot be mistaken for options

    Args:
        typed: Words of a command line
    """
def program_parser(program: str, about: str, verbs: dict, options: Any, below: str = '') -> ArgumentParser:
    """The parser of a program with verbs

    Args:
        program: Its name
        about: What it does
        verbs: `{name: function}`; a function has `examples`, and its docstring is the help
        options: A function: its parameters are the options that all verbs have
        below: More for the end of the help
    """
def part_for(function: Any, typed: Any) -> dict:
    """What of it is for `function`

    Args:
        function: As for `words_of`
        typed: What the parser gave
    """

__all__ = ['between', 'words_of', 'add_words', 'shielded', 'program_parser', 'part_for']
