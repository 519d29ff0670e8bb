"""`uav-camera`: cameras from a shell."""
from UAV.shooting.choosing import camera_program
from UAV.shooting import looking, taking, triggering, adjusting, sources, tracking, setting, storages, filing

__all__ = ['camera_program']        # each of the other rooms adds its verbs to it
