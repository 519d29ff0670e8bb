"`async with client.control():` takes control of a gimbal, and gives it back, also when something fails."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
