"Track from a shell what is at a place in the picture, see where it is now, and stop."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def target_text(now: Any) -> str:
    """What a camera tracks, for people

    Args:
        now: A `TrackingStatus`
    """
def target_object(now: Any) -> dict:
    """The same for programs: parts of the picture; degrees

    Args:
        now: A `TrackingStatus`
    """
def part(text: str) -> Any: ...
async def track_target(shooting: Any, place: list[Any], stop: bool = False, watch: bool = False) -> Any:
    """Track what is in the picture there; without a place, say what is tracked

    Args:
        place: X Y, or LEFT TOP RIGHT BOTTOM: parts of the picture, 0 to 1
        stop: Track no more
        watch: Say where it is, again and again, until Ctrl-C
    """

__all__ = ['part', 'target_text', 'target_object', 'track_target']
