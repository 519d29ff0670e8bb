"""Cameras and gimbals for MAVLink, in Python."""
__version__ = "0.1.0"

import os
os.environ.setdefault('MAVLINK20', '1')   # pymavlink reads it once, when it is imported
