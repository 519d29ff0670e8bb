"A style sheet for bright sun and for the night, for a laptop and for a phone, and inside a notebook."
# Written by .ci/stubs.py from the live classes: do not edit.

panel_colours: dict
css_colours: str
css_base: str
css_words: str
css_top: str
css_cards: str
css_picture: str
css_picture_gone: str
css_pills: str
css_buttons: str
css_chosen: str
css_states: str
css_controls: str
css_fields: str
css_pad: str
css_pad_arrows: str
css_gimbal: str
css_about: str
css_thumbnails: str
css_log: str
css_log_words: str
css_lost: str
css_sizes: str
css_phone: str
css_phone_log: str
css_touch: str
panel_css: str

__all__ = [
    'panel_colours', 'css_colours', 'css_base', 'css_words', 'css_top', 'css_cards', 'css_picture', 'css_picture_gone',
    'css_pills', 'css_buttons', 'css_chosen', 'css_states', 'css_controls', 'css_fields', 'css_pad', 'css_pad_arrows',
    'css_gimbal', 'css_about', 'css_thumbnails', 'css_log', 'css_log_words', 'css_lost', 'css_sizes', 'css_phone',
    'css_phone_log', 'css_touch', 'panel_css',
]
