"""Video: frames in, bytes out, and back again. It has never heard of MAVLink, nor of cameras."""
__all__ = ['AccessUnit', 'Encoder', 'Player', 'PlayerError', 'RTPSender', 'RTSPServer', 'Recorder', 'Sink', 'TSSender', 'TSServer', 'VideoFormat', 'VideoStream', 'strip']

def __getattr__(name):
    "All of these when one is asked for: a program without video need not load any. (Each class is whole in its own room.)"
    if name not in __all__: raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from UAV.video.units import AccessUnit, Sink, VideoFormat
    from UAV.video.encoder import Encoder
    from UAV.video.rtp import RTPSender
    from UAV.video.mpegts import TSSender, TSServer
    from UAV.video.rtsp_server import RTSPServer
    from UAV.video.stream import VideoStream
    from UAV.video.recorder import Recorder
    from UAV.video.player import Player, PlayerError, strip
    globals().update({k: v for k,v in locals().items() if k in __all__})
    return globals()[name]

def __dir__(): return sorted({*globals(), *__all__})
