"Check from a shell whether a camera keeps to the protocol: a table, a page, and an exit code."
# Written by .ci/stubs.py from the live classes: do not edit.

def uav_camera_check() -> None:
    "The program `uav-camera-check`; its options are the parameters of `check_options`"

__all__ = ['uav_camera_check']
