"""MAVLink components: everything that people import, in one place."""
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from UAV.mavlink.mavcom import MAVCom
from UAV.mavlink import fences, routing, commands, finding, event_loop, camera_commands, camera_video, camera_verbs, camera_fov, video_client, capture     # classes grow in later rooms
from UAV.mavlink import camera_storages, camera_sources, camera_tracking, camera_vehicle, camera_trigger, camera_parameters, parameter_client, ftp_changes, ftp_server, ftp_client, ftp_folders
from UAV.mavlink import gimbal_steering, gimbal_commands, gimbal_intervals, gimbal_setpoints, gimbal_roi, gimbal_mount, gimbal_finding, gimbal_hold, gimbal_at, gimbal_camera, gimbal_verbs
from UAV.wire.lossy import LossyLink
from UAV.wire.message_log import MessageLog
from UAV.wire.tlog import ReplayLink
from UAV.mavlink.component import Component, __getattr__ as _mavutil
from UAV.mavlink.camera_client import CameraClient
from UAV.mavlink.camera_server import CameraServer
from UAV.mavlink.gimbal_client import GimbalClient
from UAV.mavlink.gimbal_server import GimbalServer

__all__ = ['MAVCom', 'CameraClient', 'CameraServer', 'Component', 'GimbalClient', 'GimbalServer', 'GimbalServerViewsheen', 'LossyLink', 'MessageLog', 'ReplayLink', 'SimAutopilot', 'mavlink', 'mavutil']

def __getattr__(name):
    "What many programs do without, when it is asked for: a driver, a simulated autopilot, and `mavutil`"
    if name=='GimbalServerViewsheen': from UAV.mavlink.viewsheen_server import GimbalServerViewsheen as found
    elif name=='SimAutopilot': from UAV.mavlink.sim_autopilot import SimAutopilot as found
    else: return _mavutil(name)
    return globals().setdefault(name, found)

def __dir__(): return sorted({*globals(), *__all__})
