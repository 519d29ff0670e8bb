"Wait for a component's heartbeat, measure how far away it is in time, and compare its clock with yours: HEARTBEAT, PING, TIMESYNC."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass


@dataclass(frozen=True)
class TimeSync:
    "How long a question and its answer take, and how far the other's clock is ahead of ours; seconds"
    round_trip: float
    offset: float

__all__ = ['TimeSync']
