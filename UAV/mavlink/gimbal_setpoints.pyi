"Steer a gimbal with a joystick, by messages that say again and again where to point or how fast to turn."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def rates_of(msg: Any) -> tuple:
    "The rates of a message, rad/s: about x, y and z"

__all__ = ['rates_of']
