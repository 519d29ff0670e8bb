"""MAVLink components: everything that people import, in one place. Each name is loaded when it is asked for."""
from pymavlink.dialects.v20 import ardupilotmega as mavlink
_rooms = {'UAV.mavlink.mavcom': 'MAVCom', 'UAV.mavlink.component': 'Component mavutil', 'UAV.mavlink.camera_client': 'CameraClient RemoteCamera ask_all capture_together',
          'UAV.mavlink.camera_server': 'CameraServer', 'UAV.mavlink.gimbal_client': 'GimbalClient', 'UAV.mavlink.gimbal_server': 'GimbalServer',
          'UAV.mavlink.viewsheen_server': 'GimbalCameraServer GimbalServerViewsheen', 'UAV.mavlink.sim_autopilot': 'SimAutopilot',
          'UAV.wire.dialect': 'Ack Busy CommandError Denied Failed LinkError Lost MAVError NoAnswer Unsupported',
          'UAV.wire.lossy': 'LossyLink', 'UAV.wire.message_log': 'MessageLog', 'UAV.wire.tlog': 'ReplayLink'}
__all__ = ['Ack', 'Busy', 'CameraClient', 'CameraServer', 'CommandError', 'Component', 'Denied', 'Failed',
           'GimbalCameraServer', 'GimbalClient', 'GimbalServer', 'GimbalServerViewsheen', 'LinkError', 'LossyLink', 'Lost',
           'MAVCom', 'MAVError', 'MessageLog', 'NoAnswer', 'RemoteCamera', 'ReplayLink', 'SimAutopilot', 'Unsupported',
           'ask_all', 'capture_together', 'mavlink', 'mavutil']

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
