"Show a frame in a notebook, several side by side, or one beside a plot; and write text on it."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def as_bgr(image: Any) -> Any:
    """`image` as OpenCV likes it; raises `ValueError` when it is no picture

    Args:
        image: Array H×W, H×W×1, H×W×3 or H×W×4; integers 0…255 or floats 0…1
    """
def small_jpeg(image: Any, width: int = 480, limit: int = 36000) -> bytes:
    """`image` as a JPEG of less than `limit` bytes, with the best quality that fits; `ValueError` when none does

    Args:
        image: Picture, see `as_bgr`
        width: Wider pictures are shrunk to this, pixels
        limit: Most bytes it may take (48 kB as text in a notebook)
    """

class Thumbnail:
    "A picture that shows itself: a small JPEG in a notebook, its size in a terminal"
    image: Any
    width: int
    def __init__(self, image: Any, width: int = 480) -> None:
        """
        Args:
            image: Picture, see `as_bgr`
            width: Widest it is shown, pixels
        """
def puttext(
        img: Any, text: str, pos: Any = ..., fontscale: Any = 2.0, thickness: Any = 2, textcolor: Any = ...,
        backcolor: Any = ...,
) -> Any:
    """Write `text` in a box on `img`

    Args:
        img: BGR picture, changed in place
        text: Text to write; OpenCV's fonts know ASCII only
        pos: Left end of the base line, (x,y) pixels; `None` is the middle of the picture
        fontscale: 1.0 is about 22 pixels high
        thickness: Of the lines, pixels
        textcolor: BGR
        backcolor: BGR of the box
    """
def contact_sheet(images: Any, columns: int = 4, width: int = 160, labels: Any = None) -> Any:
    """`images` in rows, on one picture; `ValueError` when there are none, or not as many labels

    Args:
        images: Pictures, see `as_bgr`; sizes may differ
        columns: Pictures in a row
        width: Of each picture, pixels
        labels: One text for each picture
    """
def show_image(
        im: Any, ax: Any = None, figsize: Any = None, title: Any = None, text: Any = None, fontsize: Any = 12,
        ctx: Any = None, rgb2bgr: bool = False, **kwargs: Any
) -> Any:
    """Show a picture on `ax`; `ValueError` when it is none

    Args:
        im: Picture: array, PIL image or PyTorch tensor, RGB
        ax: Axis to draw on; `None` makes a figure
        figsize: Inches (width, height); `None` follows the picture, 1 to 5 inches
        title: Above the picture
        text: In a white box on the picture, upper left
        fontsize: Of `text`, points
        ctx: Another name for `ax`
        rgb2bgr: Swap red and blue: for pictures from OpenCV
        kwargs: Passed to matplotlib's `imshow`
    """

__all__ = ['as_bgr', 'small_jpeg', 'Thumbnail', 'puttext', 'contact_sheet', 'show_image']
