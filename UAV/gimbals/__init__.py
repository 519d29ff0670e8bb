"""Gimbals: they point cameras, and have never heard of MAVLink. Each name is loaded when it is asked for."""
_rooms = {'UAV.gimbals.values': 'Axis GimbalAttitude GimbalError GimbalInformation HeadingUnknown PositionUnknown Setpoint VehicleState',
          'UAV.gimbals.gimbal': 'Gimbal Location RegionOfInterest direction', 'UAV.gimbals.contract': 'check_gimbal', 'UAV.gimbals.vehicle': 'FixedMount SimVehicle circle hover line strips',
          'UAV.gimbals.sim': 'SimGimbal', 'UAV.gimbals.viewsheen': 'Viewsheen ViewsheenSetup',
          'UAV.gimbals.driver': 'CardCamera GimbalCamera GimbalDriver gimbal_camera',
          'UAV.gimbals.topotek': 'Topotek',
          'UAV.gimbals.onvif': 'Onvif OnvifCamera',
          'UAV.gimbals.siyi_link': 'SiyiLink',
          'UAV.gimbals.siyi': 'Siyi',
          'UAV.gimbals.siyi_camera': 'SiyiCamera'}
__all__ = sorted(' '.join(_rooms.values()).split())

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
