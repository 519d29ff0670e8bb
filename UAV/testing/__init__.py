"""For tests, of other people's code too: marks in pictures, cameras that know the truth, a free port, logs, and fixtures for pytest."""
_rooms = {'UAV.testing.kit': 'free_port Logged mark overlap read_mark TruthCamera WireLog',
          'UAV.testing.scheduler': 'Deadlock', 'UAV.testing.simulation': 'simulated'}
__all__ = sorted(' '.join(_rooms.values()).split())

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
