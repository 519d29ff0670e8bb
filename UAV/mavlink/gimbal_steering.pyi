"All setpoints go to the gimbal by one way, and a gimbal that turns stops when the client that turns it has gone."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
