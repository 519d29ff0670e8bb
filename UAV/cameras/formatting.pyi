"Delete all pictures of a storage, wholly or not at all; and let a storage join the count of another."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
