"List, read and change the settings of a camera from a shell, in the words that the camera declares."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.parameter import Parameter
from typing import Any

def parameter_object(table: Any, name: str) -> dict:
    """What a setting is, and what it may be, for programs

    Args:
        table: As `CameraClient.parameters` gives it
        name: Of one in it
    """
async def list_settings(shooting: Any) -> None:
    "All settings: what they are now, and what they may be"
def setting_named(name: str, names: Any) -> str:
    """The name as the camera writes it; raises `UnknownParameter`

    Args:
        name: As it was typed
        names: Of all the settings that there are
    """
async def get_settings(shooting: Any, names: list[str]) -> None:
    """What some settings are now

    Args:
        names: Of the settings
    """
def typed_value(text: str, p: Parameter | None = None) -> Any:
    """What was meant: the value of an option, a number, or the text itself

    Args:
        text: As it was typed
        p: What it is for, when that is known
    """
async def set_setting(shooting: Any, name: str, value: str) -> None:
    """Change a setting

    Args:
        name: Of the setting
        value: A number, or the name of an option
    """
async def reset_settings(shooting: Any, yes: bool = False) -> None:
    """Put all settings back to their defaults

    Args:
        yes: Do it, all settings of the camera are lost
    """

__all__ = [
    'parameter_object', 'list_settings', 'setting_named', 'get_settings', 'typed_value', 'set_setting',
    'reset_settings',
]
