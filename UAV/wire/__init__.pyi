"The wire: bytes in, frames and bytes out. It has never heard of components."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.wire import (
    chart as chart, dialect as dialect, exchanges as exchanges, frames as frames, links as links, lossy as lossy,
    message_log as message_log, reader as reader, signing as signing, streams as streams, tlog as tlog,
)


__all__ = [
    'dialect', 'frames', 'reader', 'signing', 'links', 'streams', 'lossy', 'tlog', 'message_log', 'exchanges', 'chart',
]
