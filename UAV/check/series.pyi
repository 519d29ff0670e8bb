"A series has as many pictures as were asked for, one at a time, and ends when told to stop."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
