"A storage gives a film its name, and notes it before the first byte is written."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
