"Describe a camera in a TOML file, and get the pipeline that GStreamer opens."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import CameraInformation
from dataclasses import dataclass
from pathlib import Path
from typing import Any

def config_file(name: str) -> Path:
    """The path of a TOML file; raises `ValueError` when there is none

    Args:
        name: Path of a TOML file, or the name of one that comes with the package
    """
def read_sections(config: Any = None, camera_dict: dict | None = None) -> dict:
    """The sections of a configuration; raises `ValueError` when the file makes no sense

    Args:
        config: A pipeline: a string, or a list of strings; or the name of a TOML file
        camera_dict: Sections as in a TOML file, which count more than the file's
    """
def read_toml(path: Path) -> dict:
    "What a TOML file says; raises `OSError`, and `ValueError` with its path when it is no TOML"
def as_text(pipeline: Any) -> str:
    """The pipeline as one line

    Args:
        pipeline: A string, or a list of strings
    """
def fill_in(text: str, values: dict, where: str = '') -> str:
    """`text` with the values in it; raises `ValueError` for a name that has none

    Args:
        text: With `{names}`
        values: Name: value
        where: The section, for errors
    """
def information_of(section: dict) -> CameraInformation:
    """What a camera is; raises `ValueError` for a name that is unknown

    Args:
        section: As in `[camera_info]`
    """

@dataclass(frozen=True)
class Recipe:
    "A camera's pipelines, filled in"
    source: str
    frames: str = ...
    encoder: str = ...
    branches: tuple = ...
    information: CameraInformation = ...
    position: dict = ...
    parameters: dict = ...
    def line(self, gives: str = 'raw', encodes: str = '', decoder: str = 'decodebin', parser: bool = True) -> str:
        """The whole pipeline, for `gst_parse_launch`

        Args:
            gives: What the source gives: 'raw', 'jpeg', 'h264' or 'h265'
            encodes: What the encoder gives, if there is one: 'h264' or 'h265'
            decoder: For a source that gives H.264 or H.265, unless `frames` says how
            parser: Are h264parse and h265parse there?
        """
def recipe_of(sections: dict) -> Recipe:
    """What the sections say; raises `ValueError` when they make no sense

    Args:
        sections: As of `read_sections`
    """
packages: dict
def package_of(element: str) -> str | None:
    """The package that has the element; `None` when we do not know

    Args:
        element: As in `x264enc`
    """
def elements(line: str) -> list:
    """The names of its elements, without those that are only caps or the name of a tee

    Args:
        line: A pipeline
    """

__all__ = [
    'packages', 'config_file', 'read_sections', 'read_toml', 'as_text', 'fill_in', 'information_of', 'Recipe',
    'recipe_of', 'package_of', 'elements',
]
