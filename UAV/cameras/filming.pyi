"`Filming` keeps the streams and the recording of a camera, with encoders that they share."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any


class Filming:
    "The streams and the recording of a camera"
    segment: float
    camera: Any
    streams: list
    encoders: dict
    recorder: Any
    storage: Any
    closed: bool
    def __init__(self, camera: Any) -> None:
        """
        Args:
            camera: Its `frames`, `storage_for`, `announce` and `make_encoder` are used
        """
    def encoder(
            self, codec: str = 'h264', size: tuple | None = None, rate: float = 15.0, bitrate: int | None = None,
            source: str = '',
    ) -> Any:
        """An encoder for these; the one that is there, if it was asked for before

        Args:
            codec: 'h264' or 'h265'
            size: (width, height) in px; `None`: that of the frames
            rate: Pictures in a second, at most
            bitrate: bit/s; `None`: what suits size and rate
            source: Whose pictures, of a camera with several sources; empty: what it shows
        """
    def add(
            self, name: str = '', kind: str = 'rtsp', host: str = '', port: int | None = None, uri: str = '', **how: Any
    ) -> Any:
        """Add a stream, which runs at once; raises `ValueError` for a name that is there, `OSError` for a port that is taken

        Args:
            name: For people; empty: the model and a number
            kind: 'rtsp', 'rtp', 'mpegts' or 'tcp'
            host: As for `VideoStream`
            port: As for `VideoStream`
            uri: As for `VideoStream`
            how: As for `encoder`
        """
    def chosen(self, stream_id: int = 0) -> list:
        """The streams that are meant; raises `ValueError` for one that is not there

        Args:
            stream_id: 0: all
        """
    def start_recording(self, stream_id: int = 0) -> None:
        """Begin to record; raises `CameraError`, such as `CameraBusy`, or `ValueError` for a stream that is not there

        Args:
            stream_id: Whose pictures; 0: the first stream's
        """
    def stop_recording(self) -> None:
        "End the recording; its file is complete then, or the log says that the disk hangs. Fine when there is none"
    @property
    def seconds(self) -> float:
        "Length of the recording under way, s"
    def close(self) -> None:
        "End the recording, send the viewers away, and stop the encoders; may be called twice"

__all__ = ['Filming']
