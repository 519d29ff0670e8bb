"Set the colours of a GStreamer camera, and any property that its TOML file names."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.parameter import Parameter
from typing import Any

def property_of(pipeline: Any, name: str, row: dict) -> Parameter:
    """A property of an element, as a parameter; raises `ValueError` when there is none that can be set

    Args:
        pipeline: A GSTPipeline
        name: Of the parameter
        row: As in the TOML file: element and property, and what GStreamer does not know as well as you
    """
def colour_balance() -> Any:
    "GStreamer's interface of that name; `None` when its binding is not installed"
def channels_of(pipeline: Any) -> list:
    """The channels of all elements that balance colours: name, element and channel

    Args:
        pipeline: A GSTPipeline
    """
def name_of(label: str) -> str:
    "A name for a parameter"
def channel_parameter(name: str, element: Any, channel: Any) -> Parameter:
    "A channel as a parameter"

class GSTControls:
    "What a pipeline lets us set"
    table: Any
    declared: list
    made: dict
    def __init__(self, table: dict | None = None) -> None:
        """
        Args:
            table: By name of the parameter: element, property, and what else a `Parameter` has
        """
    def find(self, pipeline: Any) -> None:
        """See what there is to set; raises `ValueError` for a table that does not fit the pipeline

        Args:
            pipeline: A GSTPipeline that runs
        """
    def set(self, pipeline: Any, name: str, value: Any) -> dict:
        """Set it; raises `CameraError`

        Args:
            pipeline: A GSTPipeline that runs; `None`: none does
            name: Of a parameter
        """
    def again(self, pipeline: Any) -> None:
        "Set what was set; what the pipeline does not have yet, or not any more, is passed over"
    def leave(self, pipeline: Any) -> None:
        "Leave a device as it was found"

__all__ = ['property_of', 'colour_balance', 'channels_of', 'name_of', 'channel_parameter', 'GSTControls']
