"A camera with its gimbal is a card: its heading, its picture, its buttons, and the keys."
# Written by .ci/stubs.py from the live classes: do not edit.

js_note: str
js_row: str
js_whereabouts: str
js_heading: str
js_card: str
js_camera_views: str
js_now_turning: str
js_gimbal_of: str
js_for_others: str
js_camera_keys: str
js_camera_card: str
js_gimbal_card: str
js_in_sight: str
js_let_pictures_go: str
js_cards_shown: str
js_pictures: str
js_cards: str
script_cards: str

__all__ = [
    'js_note', 'js_row', 'js_whereabouts', 'js_heading', 'js_card', 'js_camera_views', 'js_now_turning',
    'js_gimbal_of', 'js_for_others', 'js_camera_keys', 'js_camera_card', 'js_gimbal_card', 'js_in_sight',
    'js_let_pictures_go', 'js_cards_shown', 'js_pictures', 'js_cards', 'script_cards',
]
