"A recording begins and ends when told, says so unasked, and tells how long it is."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
