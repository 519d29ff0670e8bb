"Video: frames in, bytes out, and back again. It has never heard of MAVLink, nor of cameras."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.video.decoding import PlayerError as PlayerError
from UAV.video.encoder import Encoder as Encoder
from UAV.video.mpegts import TSSender as TSSender, TSServer as TSServer
from UAV.video.player import Player as Player, strip as strip
from UAV.video.recorder import Recorder as Recorder
from UAV.video.rtp import RTPSender as RTPSender
from UAV.video.rtsp_server import RTSPServer as RTSPServer
from UAV.video.stream import VideoStream as VideoStream
from UAV.video.units import AccessUnit as AccessUnit, Sink as Sink, VideoFormat as VideoFormat


__all__ = [
    'AccessUnit', 'Encoder', 'Player', 'PlayerError', 'RTPSender', 'RTSPServer', 'Recorder', 'Sink', 'TSSender',
    'TSServer', 'VideoFormat', 'VideoStream', 'strip',
]
