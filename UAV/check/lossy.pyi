"One press is one picture and nothing goes on for ever, also on a link that loses a fifth of all frames, doubles some and mixes up their order."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
