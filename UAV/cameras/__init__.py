"""Cameras: they take pictures, and have never heard of MAVLink. Each name is loaded when it is asked for."""
_rooms = {'UAV.cameras.values': 'CameraBusy CameraError CameraInformation CameraSettings CaptureStatus DeviceStatus Frame Picture Pose StorageError Still '
                                'StorageFull StorageInformation StorageInUse RecordingEnded TrackingStatus VideoStatus WrongMode',
          'UAV.cameras.parameters': 'Option Parameter ParametersChanged UnknownParameter check_parameters', 'UAV.cameras.storage': 'Storage',
          'UAV.cameras.lens': 'Focus Lens Travel View', 'UAV.cameras.camera': 'Camera',
          'UAV.cameras.contract': 'check_camera', 'UAV.cameras.sim_world': 'SimWorld', 'UAV.cameras.sim': 'SimCamera SimDualCamera locate',
          'UAV.cameras.cv2_camera': 'CV2Camera', 'UAV.cameras.gst_cam': 'GSTCamera', 'UAV.cameras.pi_camera': 'PiCamera',
          'UAV.cameras.url_camera': 'URLCamera', 'UAV.cameras.gphoto_camera': 'GPhotoCamera', 'UAV.cameras.gpx': 'flight_gpx'}
__all__ = sorted(' '.join(_rooms.values()).split())

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
