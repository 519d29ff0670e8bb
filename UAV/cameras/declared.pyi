"`check_parameters` finds what would make a ground station show no settings."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def check_parameters(declared: Any) -> list:
    """What QGroundControl or MAVSDK would choke on, a sentence each; empty when all is well. Raises `ValueError`

    Args:
        declared: `Parameter`s
    """

__all__ = ['check_parameters']
