"Ground stations find the camera's streams by themselves, start and stop them, and record."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def own_host(host: str) -> str | None:
    """Our own address on the way to `host`; `None` when there is no way

    Args:
        host: Of the other side
    """
def ends(channel: Any, peer: Any) -> tuple:
    """`(our host, host of the peer)` on a link; both `None` when they cannot be known

    Args:
        channel: A link of a `MAVCom`
        peer: As the link names it
    """
def unique_names(names: Any) -> list:
    """`names` as they are sent: at most 31 bytes, none empty, none twice

    Args:
        names: As people gave them
    """
stream_types: dict
pushed: tuple
stream_encodings: dict

__all__ = ['stream_types', 'pushed', 'stream_encodings', 'own_host', 'ends', 'unique_names']
