"What each verb of `uav-gimbal` does: choose a gimbal, take control, do one thing, and tell how it went."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.gimbal_client import GimbalClient
from UAV.steering.visit import Program, Visitor
from UAV.wire.dialect import MAVError
from typing import Any, Literal

def degrees(text: str) -> Any: ...
def speed(text: str) -> Any: ...
def pace(text: str) -> Any: ...
def latitude(text: str) -> Any: ...
def longitude(text: str) -> Any: ...
def metres(text: str) -> Any: ...
def options(
        connection: str = 'udpin:0.0.0.0:14550', system: Any = None, component: Any = None, gimbal: Any = None,
        timeout: Any = 5.0, force: bool = False, keep: bool = False, sign: str | None = None, json: bool = False,
) -> Any:
    """What all verbs have

    Args:
        connection: MAVLink links, with commas between them
        system: System id of the gimbal; needed when there are several
        component: Component id of the gimbal, or of its manager
        gimbal: Number of the gimbal at its manager
        timeout: s to look for a gimbal; an answer may take up to 10 s
        force: Take control away from another ground station
        keep: Keep control; without it, control is given back at the end
        sign: File with the key of a signed link
        json: Say everything as JSON, one object a line
    """

class GimbalVisitor(Visitor, GimbalClient):
    "A client that is there for a moment, again and again"
about: str
gimbal_program: Program
verb: Any
async def list_(steering: Any) -> None:
    "Which gimbals there are"
async def status(steering: Any, watch: bool = False) -> None:
    """Where it points, and who is in control

    Args:
        watch: Once a second, until Ctrl-C
    """

class NotReached(MAVError):
    "The gimbal does not point where it was told"
async def angle(
        steering: Any, pitch: Any, yaw: Any, frame: Literal['vehicle', 'earth'] = 'vehicle', lock: bool = False,
        speed: Any = None, wait: bool = False,
) -> None:
    """Point there

    Args:
        pitch: From the horizon, degrees; -90 is down; nan leaves it as it is
        yaw: Degrees to the right; nan leaves it as it is
        frame: What yaw is measured from: the nose, or north
        lock: Hold the direction on earth, as with --frame earth
        speed: How fast to go there, degrees a second; without it, as fast as it likes
        wait: Wait until it is reached
    """
async def rate(steering: Any, pitch: Any, yaw: Any, seconds: Any = 2.0) -> None:
    """Turn for some time; Ctrl-C stops at once

    Args:
        pitch: Degrees a second, upwards
        yaw: Degrees a second, to the right
        seconds: How long, s
    """
async def center(steering: Any) -> None:
    "Look straight ahead"
async def retract(steering: Any) -> None:
    "Fold away"
async def lock(steering: Any) -> None:
    "Hold the direction on earth"
async def follow(steering: Any) -> None:
    "Follow the vehicle's nose"
async def roi(steering: Any, lat: Any, lon: Any, alt: Any, frame: Literal['amsl', 'relative'] = 'amsl') -> None:
    """Look at a place, until told otherwise

    Args:
        lat: Degrees
        lon: Degrees
        alt: m
        frame: Above the sea, or above where the vehicle took off
    """
async def roi_system(steering: Any, other: Any) -> None:
    """Look at another vehicle, wherever it goes

    Args:
        other: Its system id
    """
async def roi_none(steering: Any) -> None:
    "Look at the place no longer"
async def release(steering: Any) -> None:
    "Give back control that was kept; with --force also that of another"

__all__ = [
    'degrees', 'speed', 'pace', 'latitude', 'longitude', 'metres', 'about', 'gimbal_program', 'verb', 'options',
    'GimbalVisitor', 'list_', 'status', 'NotReached', 'angle', 'rate', 'center', 'retract', 'lock', 'follow', 'roi',
    'roi_system', 'roi_none', 'release',
]
