"""Keep a red car in the middle of the picture: live frames in, rates of the gimbal out.

In one terminal:  uav-camera-server --gimbal sim --autopilot
In another one:   python follow.py
"""
import math, time

import cv2, numpy as np
from UAV.mavlink import MAVCom
from UAV.script import run

GAIN, LIMIT = 4., 40.          # degrees a second for each degree of error; degrees a second
SECONDS = 8                     # how long it follows, once it has seen the car


def find(image: np.ndarray) -> tuple[float, float] | None:
    "Where something red is, px from the left and from the top; None when nothing is"
    blue, green, red = (image[..., n].astype(int) for n in range(3))
    is_red = (red > 2*np.maximum(blue, green)) & (red > 80)          # in what is dark, any colour may be noise
    spots = cv2.moments(is_red.astype(np.uint8), binaryImage=True)
    if spots['m00'] < 30: return None           # px: noise
    return spots['m10']/spots['m00'], spots['m01']/spots['m00']


def error(spot: tuple[float, float], size: tuple[int, int], hfov: float) -> tuple[float, float]:
    "How far up, and to the right, of the middle of the picture it is, degrees"
    (x, y), (width, height) = spot, size
    f = width/2/math.tan(math.radians(hfov/2))          # focal length, px
    return math.degrees(math.atan2(height/2-y, f)), math.degrees(math.atan2(x-width/2, f))


def rates(spot: tuple[float, float] | None, size: tuple[int, int], hfov: float) -> tuple[float, float]:
    "Pitch and yaw, degrees a second: in proportion to the error, up to a limit; 0 when there is nothing to follow"
    if spot is None: return 0., 0.
    up, right = error(spot, size, hfov)
    return max(-LIMIT, min(GAIN*up, LIMIT)), max(-LIMIT, min(GAIN*right, LIMIT))


async def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        camera = await ground.find_camera(timeout=10)
        gimbal = await camera.gimbal()
        seen = await camera.fov()
        hfov = seen.hfov if seen else 60.
        async with gimbal.control():
            (await gimbal.set_angles(pitch=-35, yaw=30)).check()
            await gimbal.reached()                              # where the car will come by
            try:
                began, errors = None, []
                async for frame in camera.video():
                    spot = find(frame.image)
                    pitch, yaw = rates(spot, frame.size, hfov)
                    gimbal.send_rates(pitch, yaw)               # at once: there is no ack to wait for
                    if spot: errors.append(math.hypot(*error(spot, frame.size, hfov)))
                    began = began or (time.monotonic() if spot else None)
                    if began and time.monotonic() > began+SECONDS: break
            finally: (await gimbal.set_rates()).check()         # stop: a command, sent until it's answered
        print(f'followed it for {SECONDS} s')
        print(f'at the end it was {sum(errors[-15:])/15:.1f}° from the middle')


if __name__ == '__main__': run(main)
