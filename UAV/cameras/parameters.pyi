"Set and read the parameters of a camera: a value that fits the declaration is taken, told, and kept over a restart."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.parameter import Parameter
from pathlib import Path
from typing import Any


class Parameters:
    "The values of a camera's parameters; raises `ValueError` for a name twice, or a wrong default"
    patience: float
    declared: dict
    file: Path | Any
    apply: Any
    changed: Any
    defaults: dict
    def __init__(self, declared: Any, file: str | Path | None = None, apply: Any = None, changed: Any = None) -> None:
        """
        Args:
            declared: `Parameter`s
            file: Where the values are kept; `None`: nowhere
            apply: Called with name and value; may raise, may give a dict of what moved along in the device
            changed: Called with a dict of all that moved
        """
    @property
    def names(self) -> Any:
        "In the order of the declaration, which stays"
    def keys(self) -> Any:
        "The names of the parameters"
    def __len__(self) -> Any: ...
    def __iter__(self) -> Any: ...
    def __contains__(self, name: Any) -> bool: ...
    def __getitem__(self, name: Any) -> Any: ...
    def __setitem__(self, name: Any, value: Any) -> None: ...
    def declaration(self, name: str) -> Parameter:
        "The declaration of one; raises `UnknownParameter`"
    def excluded(self, name: str) -> str:
        "Why the parameter cannot be set now, such as 'CAM_EXPMODE is Auto'; empty when it can"
    def allowed(self, name: str) -> tuple:
        "The options that fit the other values now; none while the parameter is excluded"
    def set(self, name: str, value: Any) -> dict:
        """Set one; raises `UnknownParameter`, `ValueError`, `CameraBusy`, or the `CameraError` of the device

        Args:
            name: Of the parameter
            value: A number, or the name of an option
        """
    def moved(self, values: dict) -> dict:
        """The device has done this by itself; raises `ValueError` for what it cannot be

        Args:
            values: The new values, by name
        """
    def reset(self) -> dict:
        "Put all back; raises, at the end, what the device raised first"
    def restore(self) -> None:
        "Tell the device what was kept, the first time this is called; what it refuses goes back to its default"
most_kept: int

__all__ = ['most_kept', 'Parameters']
