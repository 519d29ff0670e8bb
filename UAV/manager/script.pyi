"`panel_js`, the whole view of the panel in one script, for a page and for a notebook; with the bar at the top and the log."
# Written by .ci/stubs.py from the live classes: do not edit.

js_log_line: str
js_log: str
js_exit: str
js_users: str
js_top: str
js_holds: str
js_actions: str
js_linked: str
js_take: str
js_panel: str
js_away: str
js_mount: str
js_widget: str
js_page: str
panel_js: str

__all__ = [
    'js_log_line', 'js_log', 'js_exit', 'js_users', 'js_top', 'js_holds', 'js_actions', 'js_linked', 'js_take',
    'js_panel', 'js_away', 'js_mount', 'js_widget', 'js_page', 'panel_js',
]
