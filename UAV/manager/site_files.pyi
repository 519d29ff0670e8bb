"Answer a browser that asks for the files of a camera: lists, small pictures, and files that it saves and never shows."
# Written by .ci/stubs.py from the live classes: do not edit.

def saved_as(path: str) -> str:
    """A name for a download that needs no quoting

    Args:
        path: On a camera
    """

__all__ = ['saved_as']
