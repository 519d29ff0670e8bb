"""A control panel for cameras and gimbals."""
from UAV.manager.gui import Btn_State, Gui
from UAV.manager import camera_actions, camera_files, camera_settings, camera_target, card, finding, gimbal_actions, point, record_here, server, show, site_files     # classes grow in later rooms

__all__ = ['Btn_State', 'Gui']
