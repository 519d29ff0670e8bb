"Take a picture every few metres with any camera that knows where it is, without MAVLink."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.trigger import PlaceUnknown as PlaceUnknown, TriggerStatus as TriggerStatus


__all__ = ['PlaceUnknown', 'TriggerStatus']
