"""A control panel for cameras and gimbals. Each name is loaded when it is asked for."""
_rooms = {'UAV.manager.gui': 'Gui', 'UAV.manager.panel': 'Btn_State'}
__all__ = ['Btn_State', 'Gui']

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
