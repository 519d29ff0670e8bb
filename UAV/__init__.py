"""Cameras and gimbals for MAVLink, in Python: `from UAV import MAVCom, CameraClient` loads what you name, and no more."""
__version__ = "0.1.0"

import os
os.environ.setdefault('MAVLINK20', '1')   # pymavlink reads it once, when it is imported

_rooms = {'UAV.mavlink': 'MAVCom CameraClient CameraServer GimbalClient GimbalServer LossyLink MessageLog RemoteCamera Ack '
                         'MAVError LinkError NoAnswer Lost CommandError Denied Unsupported Busy Failed capture_together',
          'UAV.cameras': 'Camera SimCamera CV2Camera GSTCamera CameraError Picture', 'UAV.gimbals': 'Gimbal SimGimbal GimbalError',
          'UAV.ftp.frames': 'FtpError', 'UAV.utils.values': 'UAVError', 'UAV.manager': 'Gui'}
__all__ = sorted(' '.join(_rooms.values()).split())

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
