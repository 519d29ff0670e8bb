"For tests: use a page in a browser with a mouse, a finger and a keyboard, and take the page or the network away."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
