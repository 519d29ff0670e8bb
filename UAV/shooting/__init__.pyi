"`uav-camera`: cameras from a shell."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.shooting import (
    adjusting as adjusting, filing as filing, looking as looking, setting as setting, sources as sources,
    storages as storages, taking as taking, tracking as tracking, triggering as triggering,
)
from UAV.shooting.choosing import camera_program as camera_program


__all__ = ['camera_program']
