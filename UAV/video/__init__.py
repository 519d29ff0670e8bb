"""Video: frames in, bytes out. It has never heard of MAVLink, nor of cameras."""
from UAV.video.units import AccessUnit, Sink, VideoFormat
