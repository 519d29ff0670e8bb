"Tracking starts at a point or a rectangle, tells where the target is, and stops."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
