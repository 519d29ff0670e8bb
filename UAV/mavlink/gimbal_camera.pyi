"Zoom and take pictures with a gimbal client: with the gimbal itself, or with a camera beside it."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
