"The panel gives each camera and each gimbal that is heard a row, and keeps the row while it is lost."
# Written by .ci/stubs.py from the live classes: do not edit.

HEARTBEAT: int

__all__ = ['HEARTBEAT']
