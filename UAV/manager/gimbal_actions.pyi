"Hold to turn, centre, look down, fold away, lock and follow, take control and give it back."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
