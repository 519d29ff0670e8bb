"""What tests need: peers, cables, environments. Nothing else of the package imports this."""
from UAV.testing.actor import Actor, play
from UAV.testing.autopilot import Autopilot
from UAV.testing.cable import Cable
from UAV.testing.desk import desk
from UAV.testing.device_tester import DeviceTester
from UAV.testing.ground_station import GroundStation
from UAV.testing.marks import mark, read_mark
from UAV.testing.peer import Peer, free_port
from UAV.testing.programs import mavproxy, own_environment
from UAV.testing.watching import Logged, Quick

__all__ = ['Actor', 'Autopilot', 'Cable', 'DeviceTester', 'GroundStation', 'desk', 'Logged', 'Peer', 'Quick', 'free_port', 'mark', 'mavproxy', 'own_environment', 'play', 'read_mark']
