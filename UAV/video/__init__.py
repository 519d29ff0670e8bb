"""Video: frames in, bytes out, and back again. It has never heard of MAVLink, nor of cameras."""
from UAV.video.units import AccessUnit, Sink, VideoFormat
from UAV.video.encoder import Encoder
from UAV.video.rtp import RTPSender
from UAV.video.mpegts import TSSender, TSServer
from UAV.video.rtsp_server import RTSPServer
from UAV.video.stream import VideoStream
from UAV.video.recorder import Recorder
from UAV.video.player import Player, PlayerError, strip
