"Use a camera from a shell: list, look, shoot, record, set and fetch, one command at a time."
# Written by .ci/stubs.py from the live classes: do not edit.

def uav_camera() -> None:
    "The program `uav-camera`; its verbs are functions in `UAV.shooting`"

__all__ = ['uav_camera']
