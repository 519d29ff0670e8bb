"Make a picture lighter, darker, bluer or yellower, as exposure, white balance and colours of a simulated camera are set."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

usual_shutter: float
usual_iso: int
def stops_of(shutter: float, iso: float) -> float:
    """How many stops lighter a picture is than it should be

    Args:
        shutter: Exposure time, s
        iso: Sensitivity
    """
def auto_exposure(ev: float) -> dict:
    """The parameters that an automatic exposure chooses

    Args:
        ev: Stops that the picture shall be lighter
    """
tone_table: Any
white_gains: dict
colour_matrices: Any
def menu(names: Any) -> dict:
    """Options that count from 0

    Args:
        names: Of the options
    """
sim_parameters: list
def light(values: Any) -> float:
    """How many stops lighter the picture is than it should be

    Args:
        values: Of the parameters, by name
    """
def develop(image: Any, values: Any) -> Any:
    """The picture as the parameters want it; the same object when they want nothing

    Args:
        image: BGR, uint8
        values: Of the parameters, by name
    """

__all__ = [
    'usual_shutter', 'usual_iso', 'white_gains', 'sim_parameters', 'stops_of', 'auto_exposure', 'tone_table',
    'colour_matrices', 'menu', 'light', 'develop',
]
