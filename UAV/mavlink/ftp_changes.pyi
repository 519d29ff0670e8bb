"Let clients write, rename and remove files of a vehicle, and compare checksums."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
