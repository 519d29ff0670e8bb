"""What tests need: peers, cables, environments. Nothing else of the package imports this."""
from UAV.testing.cable import Cable
from UAV.testing.desk import desk
from UAV.testing.marks import mark, read_mark
from UAV.testing.peer import Peer, free_port
from UAV.testing.programs import mavproxy, own_environment
from UAV.testing.watching import Logged, Quick

__all__ = ['Cable', 'desk', 'Logged', 'Peer', 'Quick', 'free_port', 'mark', 'mavproxy', 'own_environment', 'read_mark']
