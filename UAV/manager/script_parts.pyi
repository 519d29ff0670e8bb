"Small functions in JavaScript that the whole panel uses: elements, words, buttons, sliders, and what is held down."
# Written by .ci/stubs.py from the live classes: do not edit.

js_element: str
js_say: str
js_show: str
js_group: str
js_icons: str
js_icon: str
js_clock: str
js_numbers: str
js_state: str
js_paint_all: str
js_button: str
js_latest: str
js_following: str
js_slider: str
js_hold: str
js_press_or_hold: str
script_parts: str

__all__ = [
    'js_element', 'js_say', 'js_show', 'js_group', 'js_icons', 'js_icon', 'js_clock', 'js_numbers', 'js_state',
    'js_paint_all', 'js_button', 'js_latest', 'js_following', 'js_slider', 'js_hold', 'js_press_or_hold',
    'script_parts',
]
