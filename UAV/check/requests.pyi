"After REQUEST_MESSAGE and the older request commands the message comes, after the ack, with values that can be true."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
