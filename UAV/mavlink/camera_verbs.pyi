"Set mode, zoom and focus, format a card, record and stream: each verb sends one command and returns an `Ack`."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
