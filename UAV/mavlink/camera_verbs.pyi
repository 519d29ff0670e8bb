"Set mode, zoom and focus, format a card, record and stream: each verb sends one command and returns an `Ack`."
# Written by .ci/stubs.py from the live classes: do not edit.

def number_of(enum: str, value: int | str, prefix: str) -> int:
    """The number of `value`; raises `ValueError` for a word that `enum` has not

    Args:
        enum: Its name in the dialect
        value: A number, or a word such as `'range'`
        prefix: What the dialect writes before the word
    """

__all__ = ['number_of']
