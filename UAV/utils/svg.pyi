"Draw with SVG: elements, colours for light and dark pages, and the width of words."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def element(tag: str, *inside: str, **attributes: Any) -> str:
    """An element of an SVG

    Args:
        tag: As in 'rect'
        inside: Other elements
        attributes: `_` becomes `-`, `cls` is `class`; what is `None` is left out
    """
def path(d: str, **attributes: Any) -> str:
    """A line in the current colour

    Args:
        d: As in 'M0 0H10': from 0,0 to the right
    """
def text(x: float, y: float, words: str, *classes: str) -> str:
    """Words

    Args:
        x, y: Pixels; `y` is the base line
        words: Escaped here
        classes: A colour, `middle` or `end` (where `x` is), `bold`, `plain` (no margin in the paper's colour)
    """
letter_height: int
letter_width: float
def text_width(words: str) -> float:
    "Pixels that `words` need"
dark_pages: str
def css_class(name: str) -> str:
    "`name` as a class; a class has no spaces"
def css(rules: dict, of: str) -> str:
    """`rules` as a style sheet

    Args:
        rules: `{selector: declarations}`
        of: Each is only for elements in here
    """
def colour_rules(colours: dict, dark: bool) -> dict:
    """A rule for each colour; letters have a margin in the colour of the paper

    Args:
        colours: `{name: (on light pages, on dark pages)}`, with one named `paper`
        dark: For dark pages
    """

class Drawing:
    "An SVG that shows itself in a notebook, in the colours of the page"
    least: int
    name: str
    colours: dict
    width: int
    height: int
    inside: tuple
    rules: dict
    def __init__(self, name: str, colours: dict, width: int, height: int, *inside: str, rules: dict | None = None) -> None:
        """
        Args:
            name: Class of the `<svg>`: its rules are only for drawings of this name
            colours: `{name: (on light pages, on dark pages)}`, with one named `paper`
            width: Pixels
            height: Pixels
            inside: Elements
            rules: More rules, `{selector: declarations}`
        """
    @property
    def svg(self) -> str:
        "All of it, with the colours for light pages"
    def save(self, file: Any) -> None:
        """Write it

        Args:
            file: An `.svg`
        """
def solid_arrow(x0: Any, x1: Any, y: Any, way: Any, weight: Any = 2, dashes: Any = None) -> str:
    "From `x0` to `x1`, with a solid head"
def open_arrow(x0: Any, x1: Any, y: Any, way: Any, weight: Any = 1.5) -> str:
    "From `x0` to `x1`, with an open head"
def crossed_out(x: Any, y: Any, way: Any, words: Any, cross: Any = 'failed') -> str:
    "Dashes that come out of `x` against `way`, a cross in the colour `cross`, and `words` behind it"
def time_unit(span: float) -> tuple:
    """`(how many are in a second, name)` of the unit for `span`

    Args:
        span: Seconds
    """
def tick_step(span: float, pixels: float, apart: int = 34) -> float:
    """Seconds from one tick to the next: 1, 2 or 5 of a power of ten

    Args:
        span: Seconds
        pixels: That they take
        apart: Pixels between two ticks at least
    """
def time_ruler(span: float, top: float, bottom: float, colour: str = 'soft') -> str:
    """A ruler at the left edge, 58 pixels wide

    Args:
        span: Seconds
        top, bottom: Pixels: where 0 is, and where `span` is
    """
def contrast(one: str, other: str) -> float:
    "Of two colours, written as '#rrggbb': 1 (the same) to 21 (black and white), as WCAG 2.1 defines it"

__all__ = [
    'letter_height', 'letter_width', 'dark_pages', 'element', 'path', 'text', 'text_width', 'css_class', 'css',
    'colour_rules', 'Drawing', 'solid_arrow', 'open_arrow', 'crossed_out', 'time_unit', 'tick_step', 'time_ruler',
    'contrast',
]
