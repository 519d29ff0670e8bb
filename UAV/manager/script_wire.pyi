"How the view gets news and sends presses: over HTTP on a page, over the kernel's connection in a notebook."
# Written by .ci/stubs.py from the live classes: do not edit.

js_refused: str
js_patience: str
js_http: str
js_cut: str
js_http_poll: str
js_http_act: str
js_http_files: str
js_http_wire: str
js_asking: str
js_widget_wire: str
js_visible: str
js_loop: str
script_wire: str

__all__ = [
    'js_refused', 'js_patience', 'js_http', 'js_cut', 'js_http_poll', 'js_http_act', 'js_http_files', 'js_http_wire',
    'js_asking', 'js_widget_wire', 'js_visible', 'js_loop', 'script_wire',
]
