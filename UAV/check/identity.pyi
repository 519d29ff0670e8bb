"Heartbeat, address and CAMERA_INFORMATION must be right, or no program finds the camera and knows what it can do."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def c_string(values: Any) -> str | None:
    "The text of a field of bytes; `None` when it has no end, or is none"

__all__ = ['c_string']
