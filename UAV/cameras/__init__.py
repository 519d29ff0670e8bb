"""Cameras: they take pictures, and have never heard of MAVLink."""
from UAV.cameras.values import (CameraBusy, CameraError, CameraInformation, CameraSettings, CaptureStatus, DeviceStatus, Frame, Picture, Pose,
                                StorageError, StorageFull, StorageInformation, StorageInUse, RecordingEnded, VideoStatus, WrongMode)
from UAV.cameras.parameter import Option, Parameter, ParametersChanged, UnknownParameter
from UAV.cameras.declared import check_parameters
from UAV.cameras.storage import Storage
from UAV.cameras import formatting
from UAV.cameras.lens import Focus, Lens, Travel, View
from UAV.cameras.camera import Camera
from UAV.cameras import settings, storage_usage, survey, tracking, video     # Camera grows in later rooms
from UAV.cameras.pursuit import TrackingStatus
from UAV.cameras.contract import check_camera
from UAV.cameras.sim_world import SimWorld, sim_world
from UAV.cameras.sim import SimCamera, locate
from UAV.cameras.sim_dual import SimDualCamera
from UAV.cameras.cv2_camera import CV2Camera
from UAV.cameras.gst_cam import GSTCamera
