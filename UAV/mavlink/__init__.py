"""MAVLink components: everything that people import, in one place."""
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from UAV.mavlink.mavcom import MAVCom
from UAV.mavlink import fences, routing, commands, finding, event_loop, camera_commands, camera_video, camera_verbs, camera_fov, video_client, capture     # classes grow in later rooms
from UAV.wire.lossy import LossyLink
from UAV.wire.message_log import MessageLog
from UAV.wire.tlog import ReplayLink
from UAV.mavlink.component import Component, __getattr__ as _mavutil
from UAV.mavlink.camera_client import CameraClient
from UAV.mavlink.camera_server import CameraServer

__all__ = ['MAVCom', 'CameraClient', 'CameraServer', 'Component', 'GimbalClient', 'GimbalServer', 'GimbalServerViewsheen', 'LossyLink', 'MessageLog', 'ReplayLink', 'SimAutopilot', 'mavlink', 'mavutil']

def __getattr__(name):
    "What many programs do without, when it is asked for: gimbals with all their rooms, and `mavutil`"
    if name not in ('GimbalClient','GimbalServer','GimbalServerViewsheen','SimAutopilot'): return _mavutil(name)
    from UAV.mavlink import gimbal_commands, gimbal_intervals, gimbal_setpoints, gimbal_roi, gimbal_mount
    from UAV.mavlink import gimbal_finding, gimbal_hold, gimbal_verbs
    from UAV.mavlink.gimbal_client import GimbalClient
    from UAV.mavlink.gimbal_server import GimbalServer
    from UAV.mavlink.viewsheen_server import GimbalServerViewsheen
    from UAV.mavlink.sim_autopilot import SimAutopilot
    globals().update({k: v for k,v in locals().items() if k in __all__})
    return globals()[name]

def __dir__(): return sorted({*globals(), *__all__})
