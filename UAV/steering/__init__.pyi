# Written by .ci/stubs.py from the live classes: do not edit.
