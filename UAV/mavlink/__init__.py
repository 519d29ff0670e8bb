"""MAVLink components: everything that people import, in one place."""
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from UAV.mavlink.mavcom import MAVCom
from UAV.wire.lossy import LossyLink
from UAV.wire.message_log import MessageLog, ReplayLink
from UAV.mavlink.component import Component, __getattr__   # mavutil, when somebody asks for it
from UAV.mavlink.camera_client import CameraClient
from UAV.mavlink import camera_verbs, notices, capture   # each gives CameraClient its methods
from UAV.mavlink.camera_server import CameraServer

__all__ = ['MAVCom', 'CameraClient', 'CameraServer', 'Component', 'LossyLink', 'MessageLog', 'ReplayLink', 'mavlink', 'mavutil']
