"Buttons for pictures and videos, zoom and focus, the last pictures, and what the camera tells of itself."
# Written by .ci/stubs.py from the live classes: do not edit.

js_may_take: str
js_may_record: str
js_photo_update: str
js_photo: str
js_record: str
js_record_update: str
js_record_group: str
js_mode_names: str
js_modes: str
js_sliding: str
js_zoom: str
js_focus: str
js_streams: str
js_thumbnail: str
js_thumbnails: str
js_facts: str
js_about: str
js_room: str
script_camera: str

__all__ = [
    'js_may_take', 'js_may_record', 'js_photo_update', 'js_photo', 'js_record', 'js_record_update', 'js_record_group',
    'js_mode_names', 'js_modes', 'js_sliding', 'js_zoom', 'js_focus', 'js_streams', 'js_thumbnail', 'js_thumbnails',
    'js_facts', 'js_about', 'js_room', 'script_camera',
]
