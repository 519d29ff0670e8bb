"What the server does with the two commands of the gimbal protocol: take control, and point the gimbal."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
