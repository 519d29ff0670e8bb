"Mode, zoom and focus move when told, the camera tells all where they are now, and refuses what it cannot do."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
