"One import for all that shows pictures, videos, logs and classes in a notebook or a terminal."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.utils.doc_class import ClassDoc as ClassDoc, doc_class as doc_class
from UAV.utils.pictures import (
    Thumbnail as Thumbnail, as_bgr as as_bgr, contact_sheet as contact_sheet, puttext as puttext,
    show_image as show_image, small_jpeg as small_jpeg,
)
from UAV.utils.scrolling_log import ScrollingLog as ScrollingLog, ScrollingLogHandler as ScrollingLogHandler
from UAV.utils.video_writer import Video as Video, VideoWriter as VideoWriter


__all__ = [
    'show_image', 'puttext', 'ScrollingLog', 'ScrollingLogHandler', 'VideoWriter', 'doc_class', 'as_bgr',
    'contact_sheet', 'small_jpeg', 'Thumbnail', 'Video', 'ClassDoc',
]
