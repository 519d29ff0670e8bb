"Quaternions as four plain numbers: from roll, pitch and yaw and back, one rotation after the other, and undone."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def quaternion(roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> tuple:
    """`(w, x, y, z)` of an attitude

    Args:
        roll: Degrees, right side down is positive
        pitch: Degrees, nose up is positive
        yaw: Degrees, clockwise as seen from above
    """
def euler(q: tuple) -> tuple:
    """`(roll, pitch, yaw)` in degrees; straight up and down the roll is 0, and yaw has it all

    Args:
        q: A unit quaternion
    """
def wrap(angle: float) -> float:
    """The same direction as -180 ≤ angle < 180

    Args:
        angle: Degrees
    """
def product(p: tuple, q: tuple) -> tuple:
    "The turn `q`, in the axes that `p` has turned"
def inverse(q: tuple) -> tuple:
    "The turn back"
def turned(q: tuple, v: tuple) -> tuple:
    """The vector `v`, turned by `q`

    Args:
        q: A unit quaternion
        v: Three numbers
    """
def unit(q: Any) -> tuple:
    """`q` with a length of 1; raises `ValueError` when it is not finite, or its length is not 1 within 10 %

    Args:
        q: Four numbers
    """

__all__ = ['quaternion', 'euler', 'wrap', 'product', 'inverse', 'turned', 'unit']
