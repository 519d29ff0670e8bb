"Write the URL of a file on a vehicle as all ground stations understand it, and read all three forms that are in use."
# Written by .ci/stubs.py from the live classes: do not edit.

def ftp_url(path: str, component: int | None = None) -> str:
    """The URL of a file

    Args:
        path: On the component, such as `/media/IMG_000000.jpg`
        component: Which one; `None`: the one that sends the URL
    """
def read_ftp_url(url: str) -> tuple:
    """The component, `None` when it is not named, and the path, which starts with a slash; raises `ValueError`

    Args:
        url: Or only a path
    """
def plain_path(text: str) -> str:
    """The path that is meant, with the component cut off

    Args:
        text: As it came in a request
    """

__all__ = ['ftp_url', 'read_ftp_url', 'plain_path']
