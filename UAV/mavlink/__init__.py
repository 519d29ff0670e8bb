"""MAVLink components: everything that people import, in one place."""
from pymavlink.dialects.v20 import ardupilotmega as mavlink
from UAV.mavlink.mavcom import MAVCom
from UAV.mavlink.component import Component
from UAV.mavlink.camera_client import CameraClient
from UAV.mavlink.camera_server import CameraServer
from UAV.mavlink.component import __getattr__   # mavutil, when somebody asks for it

__all__ = ['MAVCom', 'CameraClient', 'CameraServer', 'Component', 'mavlink', 'mavutil']
