"A control panel for cameras and gimbals."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager import (
    camera_actions as camera_actions, camera_files as camera_files, camera_settings as camera_settings,
    camera_target as camera_target, card as card, finding as finding, gimbal_actions as gimbal_actions, point as point,
    record_here as record_here, server as server, show as show, site_files as site_files,
)
from UAV.manager.gui import Gui as Gui
from UAV.manager.log import Btn_State as Btn_State


__all__ = ['Btn_State', 'Gui']
