"A pad to press and hold, the arrow keys, the angles, and who has control."
# Written by .ci/stubs.py from the live classes: do not edit.

js_speed: str
js_rates: str
js_arrows: str
js_turner: str
js_keys: str
js_knob: str
js_pad_at: str
js_pad: str
js_owner: str
js_readout: str
js_gimbal_buttons: str
js_gimbal_update: str
js_gimbal: str
script_gimbal: str

__all__ = [
    'js_speed', 'js_rates', 'js_arrows', 'js_turner', 'js_keys', 'js_knob', 'js_pad_at', 'js_pad', 'js_owner',
    'js_readout', 'js_gimbal_buttons', 'js_gimbal_update', 'js_gimbal', 'script_gimbal',
]
