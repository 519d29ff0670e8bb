"The part of the view that lists the files on a card, shows small pictures of those in sight, and saves one with a click."
# Written by .ci/stubs.py from the live classes: do not edit.

js_bytes: str
js_in_turn: str
js_file_line: str
js_sights: str
js_above: str
js_files: str
script_files: str

__all__ = ['js_bytes', 'js_in_turn', 'js_file_line', 'js_sights', 'js_above', 'js_files', 'script_files']
