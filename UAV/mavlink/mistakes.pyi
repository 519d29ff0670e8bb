"Sentences that say what to type when a cell runs twice, an address is wrong, or nothing was found."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire.links import Link
from typing import Any

def variable_of(thing: Any) -> str:
    "The name of a variable of the notebook or script; empty when none is `thing`"
def how_to_close(com: Any) -> str:
    """What to type to close it

    Args:
        com: A `MAVCom`
    """
def holder_of(connection_string: str, coms: Any) -> Any:
    """The one that has this port; `None` when none has

    Args:
        connection_string: What could not be opened
        coms: The `MAVCom`s that are open
    """
def who_has_it(error: Exception, connection_string: str, coms: Any) -> str:
    """What `error` says; of a port that is in use, who has it, and what to do

    Args:
        error: Of a link that cannot be opened
        connection_string: The link
        coms: The `MAVCom`s that are open
    """
def opened(connection_string: Any, baudrate: int, coms: Any) -> Link:
    "The link; raises `LinkError`, which names the one of `coms` that has the port"
def check_id(name: str, number: Any) -> int:
    """`number`; raises `TypeError` when it is none, `ValueError` when it is not in 1 … 255

    Args:
        name: Of the argument
        number: A system or component id
    """
def check_baudrate(baudrate: Any) -> None:
    """Raise `ValueError` when it looks like a system id

    Args:
        baudrate: Of a serial port
    """
def check_type(mav_type: Any) -> int:
    """`mav_type`; raises `TypeError` when it is no number

    Args:
        mav_type: Of a component, a MAV_TYPE
    """
def check_state(state: Any) -> int:
    """`state`; raises `TypeError` when it is no number, `ValueError` when it is no MAV_STATE

    Args:
        state: Of a component, a MAV_STATE
    """
def check_target(number: Any) -> Any:
    """Raise `TypeError` when it is no number, `ValueError` when no message can carry it

    Args:
        number: A system or component id of a target; `None`: left out
    """
def name_the_others(component: Any, target: tuple, names: Any) -> str:
    """What to write, when the first number was perhaps not meant as a system; empty when it was

    Args:
        component: A client
        target: `(system, component)` that was asked, and never heard
        names: Of the arguments behind the target
    """
def check_seconds(name: str, seconds: Any) -> None:
    """Raise `TypeError` when it is no number, `ValueError` when it is negative or NaN

    Args:
        name: Of the argument or attribute
    """
def check_count(count: Any) -> None:
    "Raise `TypeError` when it is no whole number, `ValueError` when it is negative; `None` is allowed"
def not_joined(component: Any) -> str:
    "What to say of a component that is on no link"
def check_component(component: Any, com: Any) -> Any:
    """Raise `TypeError` when it is no component, `ValueError` when it is on another `MAVCom`

    Args:
        component: What is to be added
        com: To this `MAVCom`
    """
def check_free(number: int, coms: Any) -> Any:
    """Raise `ValueError` when one of them has a component with this number

    Args:
        number: A component id
        coms: The `MAVCom`s of a system that lead to the same place
    """

class Found(list):
    "What was found on the link; when it is empty, it says why"
    why: str
    def __init__(self, found: Any = ..., why: str = 'nothing was found') -> None:
        """
        Args:
            found: Cameras, or gimbals
            why: What was listened to, and heard
        """
    def __getitem__(self, i: Any) -> Any: ...

__all__ = [
    'variable_of', 'how_to_close', 'holder_of', 'who_has_it', 'opened', 'check_id', 'check_baudrate', 'check_type',
    'check_state', 'check_target', 'name_the_others', 'check_seconds', 'check_count', 'not_joined', 'check_component',
    'check_free', 'Found',
]
