"The newest picture and nothing older, words that say how old it is, and the place where you click."
# Written by .ci/stubs.py from the live classes: do not edit.

js_in_picture: str
js_condition: str
js_doing: str
js_taken: str
js_size_of: str
js_frame: str
js_picture_update: str
js_picture: str
script_picture: str

__all__ = [
    'js_in_picture', 'js_condition', 'js_doing', 'js_taken', 'js_size_of', 'js_frame', 'js_picture_update',
    'js_picture', 'script_picture',
]
