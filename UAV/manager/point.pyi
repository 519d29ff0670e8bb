"Click on a thing in the live picture, and the gimbal of that camera looks at it."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
