"Have a camera take a picture every few metres, from a shell."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def spacing(text: str) -> Any: ...
async def trigger_by_distance(shooting: Any, distance: Any, now: bool = False) -> None:
    """Have a picture taken whenever the vehicle has come so far, until `trigger 0` or `stop`

    Args:
        distance: Between two pictures, m; 0: no more pictures
        now: Take the first picture at once
    """

__all__ = ['spacing', 'trigger_by_distance']
