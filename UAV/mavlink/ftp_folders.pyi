"List folders of a vehicle, upload files and remove them."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.jail import FileEntry as FileEntry


__all__ = ['FileEntry']
