"Check whether a gimbal keeps to the protocol, yours or ours, on your desk: a list of sentences, and whether each holds."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.testing.autopilot import Autopilot
from typing import Any

def check(sentence: str) -> Any:
    """Mark a method of `DeviceTester` as a check

    Args:
        sentence: What must hold
    """

class Report(list):
    "(sentence, what is wrong or `None`) of each check"
    @property
    def problems(self) -> list:
        "The sentences that do not hold"

class NotTested(str):
    "Why a check does not apply"

class DeviceTester(Autopilot):
    "Checks a gimbal device; a gimbal that has a manager of its own is moved through that"
    period: float
    follow_flags: int
    margin: float
    settle: float
    other: Any
    heart: Any
    manager: Any
    yaw: float
    flight: Any
    orders: list
    def __init__(self, connection: str, system: int = 1, gimbal: int | None = None, speed: float = 1.0) -> None:
        """
        Args:
            connection: As pymavlink takes it: '/dev/ttyUSB0,57600'
            system: The vehicle's system id, which the gimbal must have as well
            gimbal: Component id of the gimbal; `None`: the first that is heard
            speed: How many times faster than life the gimbal's clock runs
        """
    def on_heartbeat(self, m: Any) -> None:
        "Take the first gimbal that is heard"
    def on_gimbal_manager_information(self, m: Any) -> None:
        "It has a manager of its own"
    def is_a_gimbal(self) -> Any:
        "It sends heartbeats, as a MAV_TYPE_GIMBAL"
    def has_an_id_of_gimbals(self) -> Any:
        "Its component id is one of those for gimbals: 154, or 171 to 175"
    def is_on_our_vehicle(self) -> Any:
        "Its system id is that of its vehicle"
    def says_what_it_is(self) -> Any:
        "It says within 2 s what it is, when all are asked"
    def has_an_axis(self) -> Any:
        "It can pitch or yaw, and its limits are in order"
    def reports(self) -> Any:
        "It reports its attitude at least once a second"
    def reports_to_all(self) -> Any:
        "The report is for all"
    def has_a_frame(self) -> Any:
        "The report says with one flag what its yaw is measured from"
    def has_one_device_id(self) -> Any:
        "Information and report have the same id, 0 or 1 to 6"
    def looks_ahead(self) -> Any:
        "It comes to look ahead, within 1° and 20 s"
    def looks_down(self) -> Any:
        "It looks 45° down"
    def pitches(self) -> Any:
        "It pitches to both of its limits"
    def pans(self) -> Any:
        "It pans to both sides, also while it looks down"
    def follows(self) -> Any:
        "A yaw that follows goes with the vehicle"
    def locks(self) -> Any:
        "A yaw that is locked stays"
    def pitches_at_a_rate(self) -> Any:
        "It pitches down by 10 °/s for 5 s"
    def pans_at_a_rate(self) -> Any:
        "It pans by 10 °/s for 5 s"
    def stays(self) -> Any:
        "When the rate ends, it stays where it is"
    def goes_at_a_rate(self) -> Any:
        "It goes to an angle at a given rate: half the time, half the way"
    def minds_its_manager(self) -> Any:
        "It does not move for one who is not its manager"
    def is_no_manager(self) -> Any:
        "A device without a manager takes no command for managers"
    def retracts(self) -> Any:
        "It retracts, and comes back"
    def run(self, show: Any = None) -> Report:
        """Do all checks; what is needed for the rest, and does not hold, ends it

        Args:
            show: Called with each line, as soon as it is known: `print`
        """

__all__ = ['check', 'Report', 'NotTested', 'DeviceTester']
