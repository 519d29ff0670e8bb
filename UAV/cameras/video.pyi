"Add a stream, start and stop it, start and stop a recording: five verbs that every camera has."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
