"""Test code of your own with a simulated drone, over a radio that loses every fifth message.

Copy it, and start it:   pytest test_my_drone.py      (pip install '.[test]' in a clone)
The fixtures `uav_…` come with the package. When a test fails, its report shows what passed over the radio.
"""
from typing import Any


def survey(ground: Any, count: int) -> list[Any]:
    "The code under test: so many pictures, and the notice of each"
    camera = ground.find_camera()
    camera.zoom(percent=20)
    return [notice for notice in camera.capture(count, interval=.2)]


def test_survey_takes_each_picture_once(uav_camera: Any, uav_ground: Any, uav_radio: Any, uav_log: Any) -> None:
    uav_radio(loss=.2, latency=.02, seed=4)
    notices = survey(uav_ground, 3)
    assert [notice.image_index for notice in notices] == [0, 1, 2]
    assert len(uav_camera.storage) == 3
    uav_log.has('SET_CAMERA_ZOOM', to='1/100', times=1)
    uav_log.in_order('SET_CAMERA_ZOOM', 'IMAGE_START_CAPTURE', 'CAMERA_IMAGE_CAPTURED')
    uav_log.lacks('VIDEO_START_CAPTURE')
