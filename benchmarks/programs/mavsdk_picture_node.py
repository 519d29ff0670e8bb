"""`examples/picture_node.py`, written with MAVSDK."""
import queue, sys, threading, time
from collections import defaultdict
from pathlib import Path

from mavsdk.plugins.gimbal import ControlMode, Gimbal, GimbalMode, SendMode
from mavsdk_station import Station


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
        self.station, self.component = station, station.cameras(1)[0].component_id
        self.gimbal, lists = Gimbal(station.system), queue.Queue()
        self.gimbal.subscribe_gimbal_list(lambda found, _: lists.put(found.gimbals))
        gimbals = self.gimbal.gimbal_list().gimbals
        while not gimbals: gimbals = lists.get(timeout=10)
        self.number = gimbals[0].gimbal_id
        self.subscribe('/look', self.look)

    def reached(self, pitch, yaw, timeout=10):
        end = time.monotonic()+timeout
        while time.monotonic() < end:
            now = self.gimbal.get_attitude(self.number).euler_angle_forward
            if abs(now.pitch_deg-pitch) < .4 and abs(now.yaw_deg-yaw) < .4: return now
            time.sleep(.1)
        raise RuntimeError('the gimbal does not get there')

    def look(self, view):
        try:
            self.gimbal.take_control(self.number, ControlMode.PRIMARY)
            try:
                self.gimbal.set_angles(self.number, 0, view['pitch'], view['yaw'], GimbalMode.YAW_FOLLOW, SendMode.ONCE)
                there = self.reached(**view)
            finally: self.gimbal.release_control(self.number)
            shot = self.station.shoot(self.component)
            file = self.station.fetch(self.component, shot, Path('pictures'))
            self.publish('/picture', dict(pitch=round(there.pitch_deg), yaw=round(there.yaw_deg), file=str(file)))
        except Exception as e: self.publish('/picture', dict(error=str(e)))


def main(connection='udpin://127.0.0.1:14550'):
    with Station(connection) as station:
        node, seen = PictureNode(station), threading.Semaphore(0)
        node.subscribe('/picture', lambda message: print(message, flush=True))
        node.subscribe('/picture', lambda message: seen.release())
        node.thread.start()
        views = dict(pitch=-90, yaw=0), dict(pitch=-20, yaw=-60), dict(pitch=-20, yaw=60)
        try:
            for view in views: node.publish('/look', view)
            for view in views: seen.acquire()
        finally:
            node.close()
            node.gimbal.destroy()


if __name__ == '__main__': main(*sys.argv[1:])
