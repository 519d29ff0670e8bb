"A single still is taken once, numbered and announced, and can be asked for again."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
