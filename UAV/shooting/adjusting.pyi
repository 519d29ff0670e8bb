"Zoom, focus and change the mode from a shell, in the units that people think in."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any, Literal

lens_limits: dict
def done_or_why(ack: Any, unit: str) -> None:
    """Raises what `Ack.check` raises; a refusal also says what can be typed

    Args:
        ack: Of a command to the lens
        unit: That was typed
    """
def amount(text: str) -> Any: ...
zoom_kinds: dict
async def zoom(
        shooting: Any, value: Any, unit: Literal['percent', 'step', 'speed', 'mm', 'degrees'] = 'percent',
        seconds: Any = 1.0,
) -> None:
    """Zoom: to a share of the range, by steps, for some time, or to a focal length or width of view

    Args:
        value: How far
        unit: Of the value; speed is from -1 to 1
        seconds: How long, with --unit speed
    """
focus_words: dict
def focus_value(text: str) -> Any:
    "A type for `argparse`: a number, or a way to focus by itself"
focus_kinds: dict
def focus_command(value: Any, unit: str) -> tuple:
    """The type and the value that MAVLink has for it

    Args:
        value: As `focus_value` gives it
        unit: Of the value
    """
async def focus(
        shooting: Any, value: Any, unit: Literal['percent', 'step', 'speed', 'metres'] = 'percent', seconds: Any = 1.0,
) -> None:
    """Focus: by itself, to a share of the range, by steps, for some time, or to a distance

    Args:
        value: How far; or auto, once, continuous: the camera does it
        unit: Of the value; speed is from -1 to 1
        seconds: How long, with --unit speed
    """
camera_modes: dict
async def set_mode(shooting: Any, mode: Literal['image', 'video', 'survey']) -> None:
    """Switch between taking pictures, video, and surveying

    Args:
        mode: What it is to be good at
    """

__all__ = [
    'lens_limits', 'amount', 'zoom_kinds', 'focus_words', 'focus_kinds', 'camera_modes', 'done_or_why', 'zoom',
    'focus_value', 'focus_command', 'focus', 'set_mode',
]
