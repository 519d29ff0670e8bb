"Turn a place in a picture into a direction, from the field of view and the attitude of the camera when it took the picture."
# Written by .ci/stubs.py from the live classes: do not edit.

def ray(x: float, y: float, hfov: float, vfov: float) -> tuple:
    """Forward, right and down: the direction in which a place of a picture lies; raises `ValueError`

    Args:
        x, y: Place in the picture, -1 to 1: right and down are positive
        hfov, vfov: Horizontal and vertical field of view, degrees
    """
def vertical_fov(hfov: float, size: tuple) -> float:
    """Vertical field of view of a picture with square pixels, degrees

    Args:
        hfov: Horizontal field of view, degrees
        size: Width and height of the picture, pixels
    """
def clicked(x: float, y: float, hfov: float, vfov: float, q: tuple) -> tuple:
    """Pitch and yaw of a place in a picture, degrees, yaw from what that of `q` counts from; raises `ValueError`

    Args:
        x, y: Place in the picture, as for `ray`
        hfov, vfov: Horizontal and vertical field of view, degrees
        q: How the camera was held, as a quaternion
    """
def between(p: tuple, q: tuple, share: float) -> tuple:
    """The attitude on the way from `p` to `q`

    Args:
        p, q: Unit quaternions
        share: 0 is `p`, 1 is `q`
    """

class History:
    "The attitudes of the last seconds"
    seconds: float
    def __init__(self, seconds: float = 10.0) -> None:
        """
        Args:
            seconds: How long they are kept
        """
    def add(self, time: float, q: tuple) -> None:
        """Keep an attitude

        Args:
            time: Monotonic s; what is not later than the last one is left out
            q: As a quaternion
        """
    def at(self, time: float) -> tuple | None:
        """The attitude then; the nearest one when `time` is not between two of them, `None` without any

        Args:
            time: Monotonic s
        """

__all__ = ['ray', 'vertical_fov', 'clicked', 'between', 'History']
