"What a camera must answer to the packets that QGroundControl and MAVSDK send, that a radio doubles, and that a thief sends."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
