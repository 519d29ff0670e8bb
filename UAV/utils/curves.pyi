"`curves` plots over time what you asked for and what came of it."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Plot(str):
    "An SVG that shows itself in a notebook"
def svg(fig: Any) -> Plot:
    "A matplotlib figure, the same bytes each time"
asked_for: dict
colours: tuple
def curves(x: Any, unit: str = 'degrees', width: float = 6.0, height: float = 2.2, **lines: Any) -> Plot:
    """Lines over time

    Args:
        x: Where the points are, s
        unit: Of the lines
        width, height: Inches
        lines: Numbers by name, `_` is a blank; the first are what was asked for
    """

__all__ = ['asked_for', 'colours', 'Plot', 'svg', 'curves']
