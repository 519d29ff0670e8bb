"The style of the parts of a card that you open when you want them: settings, files and the target."
# Written by .ci/stubs.py from the live classes: do not edit.

css_settings: str
css_files: str
css_tracking: str
views_css: str

__all__ = ['css_settings', 'css_files', 'css_tracking', 'views_css']
