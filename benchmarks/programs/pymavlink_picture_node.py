"""`examples/picture_node.py`, written with pymavlink."""
import math, queue, sys, threading
from collections import defaultdict
from pathlib import Path

from pymavlink.quaternion import QuaternionBase
from pymavlink_station import Station, mav


class Node:
    def __init__(self):
        self.calls, self.inbox = defaultdict(list), queue.Queue()
        self.thread = threading.Thread(target=self.spin, name='node')

    def subscribe(self, topic, call): self.calls[topic].append(call)
    def publish(self, topic, message): self.inbox.put((topic, message))

    def spin(self):
        for topic, message in iter(self.inbox.get, None):
            for call in self.calls[topic]: call(message)

    def close(self):
        self.inbox.put(None)
        self.thread.join()


class PictureNode(Node):
    def __init__(self, station):
        super().__init__()
        self.station = station
        (self.camera,), (self.gimbal,) = station.find(mav.MAV_TYPE_CAMERA, 1)[:1], station.find(mav.MAV_TYPE_GIMBAL, 1)[:1]
        self.subscribe('/look', self.look)

    def reached(self, pitch, yaw):
        self.station.command(self.gimbal, mav.MAV_CMD_SET_MESSAGE_INTERVAL, mav.MAVLINK_MSG_ID_GIMBAL_DEVICE_ATTITUDE_STATUS, 100_000)
        def angles(msg): return [math.degrees(x) for x in QuaternionBase(msg.q).euler]
        def there(msg): return all(abs(is_-to) < .4 for is_, to in zip(angles(msg)[1:], (pitch, yaw)))
        msg = self.station.wait('GIMBAL_DEVICE_ATTITUDE_STATUS', there, 10)
        if msg is None: raise RuntimeError('the gimbal does not get there')
        return angles(msg)

    def look(self, view):
        station, nan = self.station, math.nan
        try:
            station.command(self.gimbal, mav.MAV_CMD_DO_GIMBAL_MANAGER_CONFIGURE, 255, 190, -1, -1)
            try:
                station.command(self.gimbal, mav.MAV_CMD_DO_GIMBAL_MANAGER_PITCHYAW, view['pitch'], view['yaw'], nan, nan)
                there = self.reached(**view)
            finally: station.command(self.gimbal, mav.MAV_CMD_DO_GIMBAL_MANAGER_CONFIGURE, -3, -3, -1, -1)
            file = station.fetch(self.camera, station.shoot(self.camera), Path('pictures'))
            self.publish('/picture', dict(pitch=round(there[1]), yaw=round(there[2]), file=str(file)))
        except (RuntimeError, TimeoutError) as e: self.publish('/picture', dict(error=str(e)))


def main(connection='udpin:127.0.0.1:14550'):
    with Station(connection) as station:
        node, seen = PictureNode(station), threading.Semaphore(0)
        node.subscribe('/picture', lambda message: print(message, flush=True))
        node.subscribe('/picture', lambda message: seen.release())
        node.thread.start()
        views = dict(pitch=-90, yaw=0), dict(pitch=-20, yaw=-60), dict(pitch=-20, yaw=60)
        try:
            for view in views: node.publish('/look', view)
            for view in views: seen.acquire()
        finally: node.close()


if __name__ == '__main__': main(*sys.argv[1:])
