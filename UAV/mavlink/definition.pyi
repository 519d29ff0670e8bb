"Write the XML file from which a ground station draws a camera's settings, and read that of any maker."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.values import CameraInformation
from typing import Any

def definition_version(information: CameraInformation, declared: Any) -> int:
    """The version of this content, 1 to 65535: the same in each process, another one for another content

    Args:
        information: Whose maker and model stand in the file
        declared: The parameters: a list of `Parameter`
    """
def definition_xml(information: CameraInformation, declared: Any) -> bytes:
    """The camera definition file; raises `ValueError` for a value that does not fit its type

    Args:
        information: Whose maker and model stand in the file
        declared: The parameters: a list of `Parameter`
    """
def definition_xz(xml: bytes) -> bytes:
    """The file compressed, as `.xml.xz`

    Args:
        xml: As `definition_xml` gives it
    """
most_bytes: int
most_settings: int
def read_definition(data: bytes) -> list:
    """The `Parameter`s of a camera definition file of any maker; raises `ValueError` when it cannot be read at all

    Args:
        data: The file, compressed or not
    """

__all__ = ['most_bytes', 'most_settings', 'definition_version', 'definition_xml', 'definition_xz', 'read_definition']
