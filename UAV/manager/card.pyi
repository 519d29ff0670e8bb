"A panel without a kernel: the last pictures and what was known, as one small piece of HTML."
# Written by .ci/stubs.py from the live classes: do not edit.

def as_card(status: dict, pictures: dict) -> str:
    """`status` and the last pictures as HTML that needs nothing else, below 20 kB

    Args:
        status: From `Gui.status()`
        pictures: JPEG of each camera that has one, by its id
    """

__all__ = ['as_card']
