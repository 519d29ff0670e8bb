"A camera with several sources shows the one that you choose, says which streams have changed, and a thermal one tells how hot it is."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
