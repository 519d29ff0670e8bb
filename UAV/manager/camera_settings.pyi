"Give a viewer all that it needs to draw a camera's settings: groups, values, what each may be now, and why one may not be set."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.parameter import Parameter
from UAV.cameras.parameters import Parameters
from UAV.manager.camera_row import CameraRow
from typing import Any

def touches(p: Parameter) -> set:
    """Names of the parameters that it moves or rules out

    Args:
        p: Of a definition
    """
def groups_of(declared: dict) -> list:
    """Lists of names: those that touch each other, and at the end all that touch no other one

    Args:
        declared: `{name: Parameter}`
    """
def fitting(declared: dict, values: dict) -> Parameters | None:
    """Both together, which knows what may be set now; `None` when the definition contradicts itself

    Args:
        declared: `{name: Parameter}`, from any maker
        values: What the camera has
    """
def field_of(p: Parameter) -> str:
    """How it is drawn: 'choice', 'switch', 'text', 'range' or 'number'

    Args:
        p: Its declaration
    """
def setting_object(p: Parameter, value: Any, now: Parameters | None) -> dict:
    """A setting as plain values, for a viewer that draws it

    Args:
        p: Its declaration
        value: What it is
        now: As from `fitting`
    """
def settings_shown(row: CameraRow) -> list | None:
    """Groups of settings as plain values; `None`: no viewer wanted them yet

    Args:
        row: Of the panel
    """
def has_settings(row: CameraRow) -> bool:
    """Does the camera say where its definition is?

    Args:
        row: Of the panel
    """

__all__ = ['touches', 'groups_of', 'fitting', 'field_of', 'setting_object', 'settings_shown', 'has_settings']
