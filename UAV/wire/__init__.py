"""The wire: bytes in, frames and bytes out. It has never heard of components."""
from UAV.wire import tlog, message_log, exchanges, chart      # so that `MessageLog` is complete, wherever it is imported from
