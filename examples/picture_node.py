"""A node as in ROS: one thread calls its callbacks; each message turns the gimbal, takes a picture, and publishes where it is.

There is no ROS here: `Node` stands in for `rclpy.node.Node`, with a queue for each topic. In yours, the callback is the same.
In one terminal:  uav-camera-server --gimbal sim --autopilot
In another one:   python picture_node.py
"""
import queue, threading
from collections import defaultdict
from collections.abc import Callable
from typing import Any

from UAV import MAVError
from UAV.blocking import MAVCom
from UAV.script import run


class Node:
    "Subscriptions, and a thread that calls them, as ROS's executor does"
    def __init__(self) -> None:
        self.calls: dict[str, list[Callable]] = defaultdict(list)
        self.inbox: queue.Queue = queue.Queue()
        self.thread = threading.Thread(target=self.spin, name='node')

    def subscribe(self, topic: str, call: Callable) -> None: self.calls[topic].append(call)
    def publish(self, topic: str, message: Any) -> None: self.inbox.put((topic, message))

    def spin(self) -> None:
        for topic, message in iter(self.inbox.get, None):
            for call in self.calls[topic]: call(message)

    def close(self) -> None:
        self.inbox.put(None)
        self.thread.join()


class PictureNode(Node):
    "Look to where `/look` says, and publish `/picture`"
    def __init__(self, ground: MAVCom) -> None:
        super().__init__()
        self.camera, self.gimbal = ground.find_camera(timeout=10), ground.find_gimbal(timeout=10)
        self.subscribe('/look', self.look)

    def look(self, view: dict) -> None:
        "A callback that waits: for the ack, for the gimbal, and for the picture"
        try:
            with self.gimbal.control():
                self.gimbal.set_angles(**view).check()
                there = self.gimbal.reached(tolerance=.4)
            if there is None: return self.publish('/picture', dict(error='the gimbal does not get there'))
            picture = self.camera.take_picture(to='pictures')
            self.publish('/picture', dict(pitch=round(there.pitch), yaw=round(there.yaw), file=str(picture.path)))
        except MAVError as e: self.publish('/picture', dict(error=str(e)))


def main(connection: str = 'udpin:127.0.0.1:14550') -> None:
    with MAVCom(connection, source_system=255) as ground:
        node, seen = PictureNode(ground), threading.Semaphore(0)
        node.subscribe('/picture', lambda message: print(message, flush=True))
        node.subscribe('/picture', lambda message: seen.release())
        node.thread.start()
        views = dict(pitch=-90, yaw=0), dict(pitch=-20, yaw=-60), dict(pitch=-20, yaw=60)
        try:
            for view in views: node.publish('/look', view)
            for view in views: seen.acquire()
        finally: node.close()           # before the link, which its callback uses


if __name__ == '__main__': run(main)
