"""The wire: bytes in, frames and bytes out. It has never heard of components."""
from UAV.wire import dialect, frames, signing, links, lossy, tlog, message_log, exchanges, chart     # each may patch those before it

__all__ = ['dialect', 'frames', 'signing', 'links', 'lossy', 'tlog', 'message_log', 'exchanges', 'chart']
