"What the server does with each command of the camera protocol: pictures, zoom, focus, mode, storage."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
