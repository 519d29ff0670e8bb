"Open the camera, the streams, the server and the links that you name on the command line."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.camera import Camera
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

def make_camera(text: str, size: tuple | None = None, mount: Any = None, **storage: Any) -> Camera:
    """The camera that `text` means; raises `CameraError` when it cannot be opened

    Args:
        text: 'sim', 'dual', 0, /dev/video0, FILE, URL, PIPELINE.toml or 'source ! …'
        size: (width, height) in px, of the simulated camera and of a device
        mount: What a simulated camera hangs on, such as a `SimGimbal`
        storage: `folder` and `quota`, or `storages`, as for `Camera`
    """
def storage_options(folder: str, quota: float | None = None, more: list | tuple = ...) -> dict:
    """What a `Camera` is to be told of its storages; raises `CameraError` for a folder that another camera has

    Args:
        folder: Of the first one
        quota: MiB that each of them may fill
        more: Folders of the others
    """
def streams_of(camera: Any, kind: str, host: str, port: int) -> list:
    """(kind, host, port, more arguments of `Camera.add_stream`) of each stream that is meant by one

    Args:
        camera: A Camera
        kind, host, port: As from `wanted_streams`
    """
def add_streams(camera: Any, wanted: list, **how: Any) -> None:
    """Give the camera these streams; raises `CameraError` for one that cannot be had

    Args:
        camera: A Camera
        wanted: (kind, host, port) of each, as from `wanted_streams`
        how: `codec`, `size`, `rate` and `bitrate`, as for `Camera.add_stream`
    """
@contextmanager
def serving(
        camera: Any, connections: list, system: int = 1, component: int = 100, host: str | None = None,
        components: Any = ..., **how: Any
) -> Generator[Any, None, None]:
    """For a `with`: `camera` on these links; gives their `MAVCom`

    Args:
        camera: A Camera
        connections: Connection strings
        system: The vehicle's system id
        component: 100 … 105
        host: Our address for viewers; `None`: where each of them reaches us
        components: What else the vehicle has on MAVLink
        how: `signing` and `forward`, as for `MAVCom`
    """

__all__ = ['make_camera', 'storage_options', 'streams_of', 'add_streams', 'serving']
