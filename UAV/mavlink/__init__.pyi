"MAVLink components: everything that people import, in one place."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink import (
    camera_commands as camera_commands, camera_fov as camera_fov, camera_parameters as camera_parameters,
    camera_sources as camera_sources, camera_storages as camera_storages, camera_tracking as camera_tracking,
    camera_trigger as camera_trigger, camera_vehicle as camera_vehicle, camera_verbs as camera_verbs,
    camera_video as camera_video, capture as capture, commands as commands, event_loop as event_loop, fences as fences,
    finding as finding, ftp_changes as ftp_changes, ftp_client as ftp_client, ftp_folders as ftp_folders,
    ftp_server as ftp_server, gimbal_at as gimbal_at, gimbal_camera as gimbal_camera,
    gimbal_commands as gimbal_commands, gimbal_finding as gimbal_finding, gimbal_hold as gimbal_hold,
    gimbal_intervals as gimbal_intervals, gimbal_mount as gimbal_mount, gimbal_roi as gimbal_roi,
    gimbal_setpoints as gimbal_setpoints, gimbal_steering as gimbal_steering, gimbal_verbs as gimbal_verbs,
    parameter_client as parameter_client, routing as routing, video_client as video_client,
)
from UAV.mavlink.camera_client import CameraClient as CameraClient
from UAV.mavlink.camera_server import CameraServer as CameraServer
from UAV.mavlink.component import Component as Component
from UAV.mavlink.gimbal_client import GimbalClient as GimbalClient
from UAV.mavlink.gimbal_server import GimbalServer as GimbalServer
from UAV.mavlink.mavcom import MAVCom as MAVCom
from UAV.mavlink.sim_autopilot import SimAutopilot as SimAutopilot
from UAV.mavlink.viewsheen_server import GimbalServerViewsheen as GimbalServerViewsheen
from UAV.wire.lossy import LossyLink as LossyLink
from UAV.wire.message_log import MessageLog as MessageLog
from UAV.wire.tlog import ReplayLink as ReplayLink
from pymavlink import mavutil as mavutil
from pymavlink.dialects.v20 import ardupilotmega as mavlink


__all__ = [
    'MAVCom', 'CameraClient', 'CameraServer', 'Component', 'GimbalClient', 'GimbalServer', 'GimbalServerViewsheen',
    'LossyLink', 'MessageLog', 'ReplayLink', 'SimAutopilot', 'mavlink', 'mavutil',
]
