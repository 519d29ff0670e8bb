"Test a gimbal of your own: `check_gimbal` tries all that servers and people rely on."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.contract import Report
from typing import Any

def ticking(gimbal: Any, wait: Any) -> Any:
    "`wait`, with a `tick` of the gimbal each tenth of a second"
def check_information(gimbal: Any, wait: Any) -> None:
    "tells what it is"
failures: tuple
def check_attitude(gimbal: Any, wait: Any) -> None:
    "says where it points"
tolerance: float
longest_wait: float
widest: dict
def places(gimbal: Any, part: float) -> dict:
    "An angle for each axis it has, so far between the limits"
def off(gimbal: Any, angles: dict) -> float:
    "How far it is from there, degrees"
def arrives(gimbal: Any, wait: Any, angles: dict, why: str) -> None:
    "Raise `AssertionError` unless it comes there, and stays"
def check_angles(gimbal: Any, wait: Any) -> None:
    "goes where it is told"
def check_keeps(gimbal: Any, wait: Any) -> None:
    "keeps the axes of which nothing is said"
def check_limits(gimbal: Any, wait: Any) -> None:
    "stays within its limits"
def check_endless(gimbal: Any, wait: Any) -> None:
    "turns without end"
def check_bad_values(gimbal: Any, wait: Any) -> None:
    "refuses what makes no sense"
def now(gimbal: Any) -> dict:
    "The angles of the axes it has"
def stands(gimbal: Any, wait: Any, why: str) -> None:
    "Raise `AssertionError` when it moves, half a second later"
def turns(gimbal: Any, wait: Any, axis: str, rate: float, **how: Any) -> None:
    "Begin in the middle, turn one axis, and wait half a second"
def check_rates(gimbal: Any, wait: Any) -> None:
    "turns at a rate, which ends by itself"
def check_stop(gimbal: Any, wait: Any) -> None:
    "stops when it is told to, and stays there"
def check_center(gimbal: Any, wait: Any) -> None:
    "looks straight ahead"
def fly(gimbal: Any, wait: Any, s: float, start: float = 0.0, tilt: float = 0.0) -> None:
    "Tell it for `s` seconds that its vehicle turns, from where it is, or from `start`, and leans by `tilt`"
def check_lock(gimbal: Any, wait: Any) -> None:
    "holds a direction on earth"
def check_follow(gimbal: Any, wait: Any) -> None:
    "follows the nose of the vehicle"
def check_north(gimbal: Any, wait: Any) -> None:
    "points to a direction on earth"
def check_level(gimbal: Any, wait: Any) -> None:
    "keeps its pitch when the vehicle leans"
def check_retract(gimbal: Any, wait: Any) -> None:
    "folds away, and comes back"
def check_close(gimbal: Any, wait: Any) -> Any:
    "closes, and turns no more"
def checks_for(gimbal: Any) -> list:
    "The checks that `gimbal` must pass"
def check_gimbal(gimbal: Any, wait: Any = ...) -> Report:
    """Does `gimbal` do what others rely on? Raises `AssertionError` with a sentence that says what it does not

    Args:
        gimbal: A Gimbal; it is closed at the end
        wait: Lets time pass, in seconds; for one with a clock of your own: moves that clock
    """

__all__ = [
    'failures', 'tolerance', 'longest_wait', 'widest', 'ticking', 'check_information', 'check_attitude', 'places',
    'off', 'arrives', 'check_angles', 'check_keeps', 'check_limits', 'check_endless', 'check_bad_values', 'now',
    'stands', 'turns', 'check_rates', 'check_stop', 'check_center', 'fly', 'check_lock', 'check_follow', 'check_north',
    'check_level', 'check_retract', 'check_close', 'checks_for', 'check_gimbal',
]
