"Steer a gimbal from a shell: list, look, point, turn, and give control back, one command at a time."
# Written by .ci/stubs.py from the live classes: do not edit.

def uav_gimbal() -> None:
    "The program `uav-gimbal`; its verbs are the functions in `UAV.steering.verbs`"

__all__ = ['uav_gimbal']
