"Declare the settings of a camera, which are then kept, told and put back; and switch its mode."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.parameter import Parameter
from typing import Any

mode_numbers: dict
def mode_parameter(*modes: Any) -> Parameter:
    """`CAM_MODE`, for a camera that has `set_camera_mode`

    Args:
        modes: As in `Camera.modes`, the first one at first
    """

__all__ = ['mode_numbers', 'mode_parameter']
