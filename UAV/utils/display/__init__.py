"""One import for all that shows pictures, videos, logs and classes in a notebook or a terminal."""
from UAV.utils.docs import doc_class
from UAV.utils.pictures import Thumbnail, Video, VideoWriter, as_bgr, contact_sheet, puttext, show_image
from UAV.utils.output import ScrollingLog, ScrollingLogHandler

__all__ = ['show_image', 'puttext', 'ScrollingLog', 'ScrollingLogHandler', 'VideoWriter', 'doc_class', 'as_bgr', 'contact_sheet',
           'Thumbnail', 'Video']
