"Hear of every picture that a camera takes, also when the radio has lost the notice of it."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
