"""The wire: bytes in, frames and bytes out. It has never heard of components."""
from UAV.wire import dialect, frames, reader, signing, links, streams, lossy     # each may patch those before it
from UAV.wire import tlog, message_log, exchanges, chart

__all__ = ['dialect', 'frames', 'reader', 'signing', 'links', 'streams', 'lossy', 'tlog', 'message_log', 'exchanges', 'chart']
