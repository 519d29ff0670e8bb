"Point a gimbal, turn it, lock it, look at a place: each verb takes degrees, and returns an `Ack`."
# Written by .ci/stubs.py from the live classes: do not edit.

def pointing_flags(frame: str = 'vehicle', lock: bool | None = None) -> int:
    """GIMBAL_MANAGER_FLAGS; raises `ValueError`

    Args:
        frame: What yaw is measured from: 'vehicle' or 'earth'
        lock: Does yaw hold its direction on earth? `None`: one from north does
    """
pitchyaw: int
old_managers: tuple
altitude_frames: dict

__all__ = ['pitchyaw', 'old_managers', 'altitude_frames', 'pointing_flags']
