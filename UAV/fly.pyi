"Get a panel in your browser with one command: live picture, gimbal and buttons."
# Written by .ci/stubs.py from the live classes: do not edit.

def uav_gui() -> None:
    "The program `uav-gui`; its options are the parameters of `fly`"

__all__ = ['uav_gui']
