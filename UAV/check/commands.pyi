"What a camera must answer to COMMAND_LONG and COMMAND_INT, and when it must keep silent."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
