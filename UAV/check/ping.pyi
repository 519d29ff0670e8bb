"A camera echoes a PING to its sender, and does not answer an answer."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
