"""Video: frames in, bytes out, and back again. It imports neither MAVLink nor cameras. Each name is loaded on first use."""
_rooms = {'UAV.video.units': 'AccessUnit Sink VideoFormat', 'UAV.video.encoder': 'Encoder', 'UAV.video.rtsp': 'RTPSender',
          'UAV.video.senders': 'TSSender TSServer', 'UAV.video.rtsp_server': 'RTSPServer', 'UAV.video.webrtc': 'WHEPServer',
          'UAV.video.stream': 'VideoStream', 'UAV.video.recorder': 'Recorder', 'UAV.video.player': 'Player PlayerError strip'}
__all__ = sorted(' '.join(_rooms.values()).split())

def __getattr__(name):
    from UAV.utils.lazy import from_rooms
    return from_rooms(globals(), _rooms, name)

def __dir__(): return sorted({*globals(), *__all__})
