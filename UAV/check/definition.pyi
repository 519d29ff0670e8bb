"The camera definition file is where the camera says, and has all that QGroundControl and MAVSDK insist on."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
