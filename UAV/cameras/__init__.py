"""Cameras: they take pictures, and have never heard of MAVLink."""
from UAV.cameras.storage import (CameraBusy, CameraError, CameraInformation, CameraSettings, CaptureStatus, Frame, Picture, Pose, Storage,
                                 StorageFull, StorageInformation, WrongMode)
from UAV.cameras.camera import Camera, DeviceStatus, Focus, Lens, Travel, check_camera
from UAV.cameras.sim import SimCamera, SimWorld, View, locate, sim_world
from UAV.cameras.cv2_camera import CV2Camera
