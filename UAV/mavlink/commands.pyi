"`await send_command(…)` brings an `Ack` into your cell; on the other end a marked method runs, and its result becomes that ack."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
