"""Cameras and gimbals for MAVLink, in Python: `from UAV import MAVCom, CameraClient` loads what you name, and no more."""
__version__ = "0.1.0"

import os
os.environ.setdefault('MAVLINK20', '1')   # pymavlink reads it once, when it is imported

_rooms = {'UAV.mavlink': 'MAVCom CameraClient CameraServer GimbalClient GimbalServer LossyLink MessageLog '
                         'MAVError LinkError NoAnswer CommandError Denied Unsupported Busy Failed capture_together',
          'UAV.cameras': 'Camera SimCamera CV2Camera GSTCamera CameraError', 'UAV.gimbals': 'Gimbal SimGimbal GimbalError', 'UAV.manager': 'Gui'}
__all__ = ['Busy', 'CV2Camera', 'Camera', 'CameraClient', 'CameraError', 'CameraServer', 'CommandError', 'Denied',
           'Failed', 'GSTCamera', 'Gimbal', 'GimbalClient', 'GimbalError', 'GimbalServer', 'Gui', 'LinkError',
           'LossyLink', 'MAVCom', 'MAVError', 'MessageLog', 'NoAnswer', 'SimCamera', 'SimGimbal', 'Unsupported',
           'capture_together']

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
