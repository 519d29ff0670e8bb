"A rectangle that you drag on the picture, and the one that the camera follows."
# Written by .ci/stubs.py from the live classes: do not edit.

js_parts_of: str
js_put_box: str
js_dragging: str
js_no_click: str
js_target: str
script_target: str

__all__ = ['js_parts_of', 'js_put_box', 'js_dragging', 'js_no_click', 'js_target', 'script_target']
