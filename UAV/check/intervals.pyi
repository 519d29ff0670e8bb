"After SET_MESSAGE_INTERVAL a message comes as often as was asked, stops when told, and never floods the link."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
