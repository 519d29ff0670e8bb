"Test a camera of your own: `check_camera` tries all that servers and people rely on."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.contract import Report
from typing import Any

def check_information(camera: Any, seen: Any) -> None:
    "tells what it is"
def check_frame(camera: Any, frame: Any) -> None:
    "Raise `AssertionError` unless `frame` is a good one"
def check_read(camera: Any, seen: Any) -> None:
    "reads frames of the size it announces"
def check_single(camera: Any, seen: Any) -> None:
    "takes one picture, and keeps it as a JPEG"
def check_interval(camera: Any, seen: Any) -> None:
    "takes a sequence of three, and says what it is doing"
def check_bad_values(camera: Any, seen: Any) -> None:
    "refuses what makes no sense"
def check_stop(camera: Any, seen: Any) -> None:
    "stops an endless sequence, and may be stopped when idle"
def check_mode(camera: Any, seen: Any) -> None:
    "changes its mode"
def check_reset(camera: Any, seen: Any) -> None:
    "resets its settings"
def check_zoom(camera: Any, seen: Any) -> None:
    "zooms"
def check_focus(camera: Any, seen: Any) -> None:
    "focuses"
def check_declared(camera: Any, seen: Any) -> None:
    "declares parameters that ground stations can draw"
def check_set_parameters(camera: Any, seen: Any) -> None:
    "sets each parameter, and tells of it"
def check_close(camera: Any, seen: Any) -> Any:
    "closes, and leaves no thread behind"

class SeenEvents(list):
    "The events of a camera, and the threads that ran before"
    threads: Any
    def __init__(self) -> None: ...
def checks_for(camera: Any) -> list:
    "The checks that `camera` must pass"
def check_camera(camera: Any) -> Report:
    """Does `camera` do what others rely on? Raises `AssertionError` with a sentence that says what it does not

    Args:
        camera: A Camera; it is closed at the end
    """

__all__ = [
    'check_information', 'check_frame', 'check_read', 'check_single', 'check_interval', 'check_bad_values',
    'check_stop', 'check_mode', 'check_reset', 'check_zoom', 'check_focus', 'check_declared', 'check_set_parameters',
    'check_close', 'SeenEvents', 'checks_for', 'check_camera',
]
