"What tests need: peers, cables, environments. Nothing else of the package imports this."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.testing import hands as hands
from UAV.testing.actor import Actor as Actor, play as play
from UAV.testing.autopilot import Autopilot as Autopilot
from UAV.testing.browser import (
    Browser as Browser, BrowserMissing as BrowserMissing, find_chromium as find_chromium, laptop as laptop,
    phone as phone,
)
from UAV.testing.cable import Cable as Cable
from UAV.testing.desk import desk as desk
from UAV.testing.device_tester import DeviceTester as DeviceTester
from UAV.testing.ground_station import GroundStation as GroundStation
from UAV.testing.jupyterlab import JupyterLab as JupyterLab, LabPage as LabPage
from UAV.testing.kernel import Kernel as Kernel
from UAV.testing.marks import mark as mark, read_mark as read_mark
from UAV.testing.peer import Peer as Peer, free_port as free_port
from UAV.testing.programs import mavproxy as mavproxy, own_environment as own_environment
from UAV.testing.shell import Shell as Shell
from UAV.testing.truth import TruthCamera as TruthCamera, overlap as overlap
from UAV.testing.watching import Logged as Logged, Quick as Quick
from UAV.testing.webcam import Webcam as Webcam, webcam_plugged_in as webcam_plugged_in


__all__ = [
    'Actor', 'Autopilot', 'Browser', 'BrowserMissing', 'Cable', 'desk', 'DeviceTester', 'find_chromium', 'free_port',
    'GroundStation', 'JupyterLab', 'Kernel', 'LabPage', 'laptop', 'Logged', 'mark', 'mavproxy', 'overlap',
    'own_environment', 'Peer', 'phone', 'play', 'Quick', 'read_mark', 'Shell', 'TruthCamera', 'Webcam',
    'webcam_plugged_in',
]
