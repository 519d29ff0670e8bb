"""What tests need: peers, cables, environments. Nothing else of the package imports this."""
from UAV.testing.actor import Actor, play
from UAV.testing.autopilot import Autopilot
from UAV.testing.browser import Browser, BrowserMissing, find_chromium, laptop, phone
from UAV.testing.cable import Cable
from UAV.testing.desk import desk
from UAV.testing.device_tester import DeviceTester
from UAV.testing.ground_station import GroundStation
from UAV.testing import hands        # Page grows there
from UAV.testing.jupyterlab import JupyterLab, LabPage
from UAV.testing.kernel import Kernel
from UAV.testing.marks import mark, read_mark
from UAV.testing.peer import Peer, free_port
from UAV.testing.programs import mavproxy, own_environment
from UAV.testing.shell import Shell
from UAV.testing.truth import TruthCamera, overlap
from UAV.testing.watching import Logged, Quick
from UAV.testing.webcam import Webcam, webcam_plugged_in

__all__ = ['Actor', 'Autopilot', 'Browser', 'BrowserMissing', 'Cable', 'desk', 'DeviceTester', 'find_chromium',
           'free_port', 'GroundStation', 'JupyterLab', 'Kernel', 'LabPage', 'laptop', 'Logged', 'mark', 'mavproxy',
           'overlap', 'own_environment', 'Peer', 'phone', 'play', 'Quick', 'read_mark', 'Shell', 'TruthCamera', 'Webcam',
           'webcam_plugged_in']
