"What a screen reader says of a picture on this site: its caption, or the words that introduce it."
# Written by .ci/stubs.py from the live classes: do not edit.
from nbdev.process import Processor
from typing import Any

def introduction(words: str, most: int = 240) -> str:
    """The last paragraph of `words` as plain text

    Args:
        words: Markdown
        most: Letters
    """
def named_pictures(page: str, words: str) -> str:
    """`page`, with `words` for each picture and drawing that has none

    Args:
        page: HTML
        words: What to say
    """

class PicturesInWords(Processor):
    "A text for each picture that a cell shows"
    words: Any
    def begin(self) -> None:
        "Until the first words come"
    def cell(self, cell: Any) -> None:
        "Take up the words of a text, and give them to the pictures of the next code"

__all__ = ['introduction', 'named_pictures', 'PicturesInWords']
