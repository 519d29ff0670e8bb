"Put a camera on MAVLink with one command: stills, video and storage for every ground station, until Ctrl-C."
# Written by .ci/stubs.py from the live classes: do not edit.

def uav_camera_server() -> None:
    "The program `uav-camera-server`; its options are the parameters of `serve_camera`"

__all__ = ['uav_camera_server']
