"A ground station sets a distance, and the camera takes a picture whenever the vehicle has come so far: DO_SET_CAM_TRIGG_DIST and its kin."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
