"A simulated camera, gimbal, live video and autopilot in one process, to try the panel without hardware."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

@contextmanager
def sim_vehicle(
        connections: Any, path: str = 'hover', rate: float = 25.0, pitch: float = -20.0,
) -> Generator[Any, None, None]:
    """For a `with`: a vehicle with a camera on a gimbal, and its video; gives its `MAVCom`. Raises `ValueError`

    Args:
        connections: Its links, connection strings
        path: What it flies: 'hover' or 'circle'
        rate: Pictures in a second
        pitch: Where the camera looks in the beginning, degrees from the horizon
    """

__all__ = ['sim_vehicle']
