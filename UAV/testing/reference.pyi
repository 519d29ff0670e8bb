"What this site shows of a class or a function: its signature as it is written, exceptions and enums as what they are, and the functions of one cell in their order."
# Written by .ci/stubs.py from the live classes: do not edit.
import inspect
from nbdev.process import Processor
from typing import Any

def source_of(sym: Any) -> dict:
    """`{parameter: (annotation, default)}`, as the source has them

    Args:
        sym: A function or a class
    """
def as_written(p: inspect.Parameter, source: dict) -> str:
    """One parameter: as its source has it, else as Python has it

    Args:
        source: As `source_of` gives it
    """
def as_called(sym: Any, start: str) -> str:
    """The signature of `sym`, with the comments of its parameters

    Args:
        sym: A function or a class
        start: What comes before the bracket
    """
def what_it_is(sym: Any, name: str) -> str:
    """What `sym` is, as Python writes it: an enum with its members, an exception with its base, a class, a property …

    Args:
        sym: What the entry is of
        name: Its last name
    """
def in_package(name: str, sym: Any) -> Any:
    """The object in the package: its source is in a file

    Args:
        name: Qualified, as in 'MAVCom.link'
        sym: What the notebook has by this name; `None` when that does not matter
    """

class ReferenceEntry:
    "One entry of the reference, as nbdev's `renderer`"
    name: Any
    level: int
    sym: Any
    def __init__(self, sym: Any, name: str | None = None, title_level: int = 3) -> None:
        """
        Args:
            sym: A class, function or property
            name: To show instead of its own
            title_level: Of its heading
        """
    @property
    def ours(self) -> bool:
        "Was it written here?"
    @property
    def words(self) -> str:
        "The docstring, and the command of a verb"
def places_in(cells: Any) -> dict:
    """`{name of a definition, or id of a cell: its place}`

    Args:
        cells: Of a notebook as it is written
    """
def sorted_run(run: Any, places: dict) -> list:
    """`run` in the order of the notebook: no entry twice, none for special methods, none that says nothing

    Args:
        run: Entries, and cells with exported source
        places: As `places_in` gives it
    """

class EntriesInOrder(Processor):
    "The entries of a page in the order of the notebook, and the source folded"
    def begin(self) -> None:
        "Put the entries in order"
    def cell(self, cell: Any) -> None:
        "Fold its source"
def near_links(words: str, home: str, site: str) -> str:
    """`words` with relative links to the site, and without links inside code

    Args:
        words: Markdown
        home: From the page to the site's first page, as in '../'
        site: The site's address
    """

class NearLinks(Processor):
    "Links from page to page; the front page keeps its own, because it is the README as well"
    home: Any
    site: Any
    wanted: bool
    def begin(self) -> None:
        "Find out where the page is"
    def cell(self, cell: Any) -> None:
        "Change the links in its text and its outputs"

__all__ = [
    'source_of', 'as_written', 'as_called', 'what_it_is', 'in_package', 'ReferenceEntry', 'places_in', 'sorted_run',
    'EntriesInOrder', 'near_links', 'NearLinks',
]
