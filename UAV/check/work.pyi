"While a command takes long, the camera says IN_PROGRESS, and it ends the work when you take the command back."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
