"With several storages: say which is for pictures, which for films, and begin to count anew."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
