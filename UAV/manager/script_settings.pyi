"Each setting of a camera as a slider, a list or a number, as the camera declares it."
# Written by .ci/stubs.py from the live classes: do not edit.

js_reading: str
js_range_field: str
js_choice_field: str
js_number_field: str
js_switch_field: str
js_text_field: str
js_fields: str
js_dim: str
js_setting: str
js_confirmed: str
js_setting_groups: str
js_settings: str
script_settings: str

__all__ = [
    'js_reading', 'js_range_field', 'js_choice_field', 'js_number_field', 'js_switch_field', 'js_text_field',
    'js_fields', 'js_dim', 'js_setting', 'js_confirmed', 'js_setting_groups', 'js_settings', 'script_settings',
]
