"Cameras: they take pictures, and have never heard of MAVLink."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras import (
    formatting as formatting, settings as settings, storage_usage as storage_usage, survey as survey,
    tracking as tracking, video as video,
)
from UAV.cameras.camera import Camera as Camera
from UAV.cameras.contract import check_camera as check_camera
from UAV.cameras.cv2_camera import CV2Camera as CV2Camera
from UAV.cameras.declared import check_parameters as check_parameters
from UAV.cameras.gst_cam import GSTCamera as GSTCamera
from UAV.cameras.lens import Focus as Focus, Lens as Lens, Travel as Travel, View as View
from UAV.cameras.parameter import (
    Option as Option, Parameter as Parameter, ParametersChanged as ParametersChanged,
    UnknownParameter as UnknownParameter,
)
from UAV.cameras.pursuit import TrackingStatus as TrackingStatus
from UAV.cameras.sim import SimCamera as SimCamera, locate as locate
from UAV.cameras.sim_dual import SimDualCamera as SimDualCamera
from UAV.cameras.sim_world import SimWorld as SimWorld, sim_world as sim_world
from UAV.cameras.storage import Storage as Storage
from UAV.cameras.values import (
    CameraBusy as CameraBusy, CameraError as CameraError, CameraInformation as CameraInformation,
    CameraSettings as CameraSettings, CaptureStatus as CaptureStatus, DeviceStatus as DeviceStatus, Frame as Frame,
    Picture as Picture, Pose as Pose, RecordingEnded as RecordingEnded, StorageError as StorageError,
    StorageFull as StorageFull, StorageInUse as StorageInUse, StorageInformation as StorageInformation,
    VideoStatus as VideoStatus, WrongMode as WrongMode,
)
