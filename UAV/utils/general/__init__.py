"""Time stamps, under the name that they had in the original package; they are written in `UAV.utils.clock`."""
from UAV.utils.clock import date_time_str, time_since_boot_ms, time_UTC_usec

__all__ = ['time_since_boot_ms', 'time_UTC_usec', 'date_time_str']
