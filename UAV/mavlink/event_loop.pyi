"`async with MAVCom(…)`: your event loop reads the socket itself, and no thread stands between a command and its ack."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
