"The streams of a camera are numbered without gaps, and have names and addresses that a player understands."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
