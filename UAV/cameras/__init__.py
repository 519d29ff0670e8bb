"""Cameras: they take pictures, and have never heard of MAVLink."""
from UAV.cameras.values import (CameraBusy, CameraError, CameraInformation, CameraSettings, CaptureStatus, DeviceStatus, Frame, Picture, Pose,
                                StorageError, StorageFull, StorageInformation, StorageInUse, RecordingEnded, VideoStatus, WrongMode)
from UAV.cameras.storage import Storage
from UAV.cameras.lens import Focus, Lens, Travel, View
from UAV.cameras.camera import Camera
from UAV.cameras import video
from UAV.cameras.contract import check_camera
from UAV.cameras.sim_world import SimWorld, sim_world
from UAV.cameras.sim import SimCamera, locate
from UAV.cameras.cv2_camera import CV2Camera
from UAV.cameras.gst_cam import GSTCamera
