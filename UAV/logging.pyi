"A logger for each part of the package: you choose how much each of them says, and where it goes."
# Written by .ci/stubs.py from the live classes: do not edit.
import logging


class LogLevels:
    "Levels for `loglevel` arguments; plain ints of the `logging` module"
    NONE: int
    DEBUG: int
    INFO: int
    WARNING: int
    ERROR: int
    CRITICAL: int
def get_logger(name: str, loglevel: int = ...) -> logging.Logger:
    """The logger `UAV.<name>`, set to `loglevel`

    Args:
        name: For example 'camera_server.100'
        loglevel: Messages below this level are dropped; `NONE` leaves it to the parent logger
    """

__all__ = ['LogLevels', 'get_logger']
