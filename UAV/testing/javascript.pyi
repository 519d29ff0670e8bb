"For tests: run a piece of JavaScript from Python, and make a page of pieces."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def run_js(script: str, expression: str) -> Any:
    """The value of `expression` after `script`; raises `ValueError` with what Node.js says of an error

    Args:
        script: A module: it may wait, import and export
        expression: It is waited for, too
    """
def test_js(script: str, expression: str, expected: Any) -> None:
    """Check that `expression` gives `expected` after `script`; without Node.js, check nothing

    Args:
        script: See `run_js`
        expression: See `run_js`
        expected: A value that JSON knows
    """
def as_page(script: str, style: str = '', html: str = '') -> str:
    """The address of a page that has all this in it

    Args:
        script: A module
        style: A style sheet
        html: What is in the page before the script runs
    """

__all__ = ['run_js', 'test_js', 'as_page']
