"Run a row of checks on a camera or a gimbal of your own: the first that fails says what is wrong, and a device that passes gets them as a list."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Report(str):
    "Text that shows itself as it is"
def kept(device: Any, checks: Any, *args: Any) -> Report:
    """What the device does, as a list; raises `AssertionError` with a sentence that says what it does not

    Args:
        device: What is put to the test; it is closed at the end
        checks: Functions of the device and `args`, which raise `AssertionError`; their docstrings say what it does
        args: For the checks
    """

__all__ = ['Report', 'kept']
