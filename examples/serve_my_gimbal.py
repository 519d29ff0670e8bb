"""Make a MAVLink gimbal of your own motors: here two hobby servos for pitch and yaw, on a Pololu Maestro.

In one terminal:  python serve_my_gimbal.py udpout:127.0.0.1:14550 /dev/ttyACM0
In another one:   uav-gimbal angle -45 30       (QGroundControl needs an autopilot, too)
Without a port, the servos are simulated. Ctrl-C ends it.
"""
import threading, time
from collections.abc import Callable
from typing import Protocol

import serial
from UAV.gimbals import Axis, Gimbal, GimbalAttitude, GimbalError, GimbalInformation, Setpoint
from UAV.mavlink import GimbalServer, MAVCom
from UAV.script import run
from UAV.utils.geo import quaternion

LIMITS = {'pitch': (-90., 30.), 'yaw': (-90., 90.)}      # degrees
CENTRE, DEGREE = 6000, 2000/90          # a servo's pulse in quarters of a microsecond, and what a degree is worth


class Port(Protocol):
    "What we use of a serial port"
    def write(self, data: bytes, /) -> int | None: ...
    def read(self, count: int, /) -> bytes: ...


class SimPort:
    "A board with two servos that take their time"
    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self.clock, self.then, self.answer = clock, clock(), b''
        self.at, self.goal, self.speed = [float(CENTRE)]*2, [CENTRE]*2, [0]*2

    def write(self, data: bytes, /) -> int:
        seconds, self.then = self.clock()-self.then, self.clock()
        for n, at in enumerate(self.at):
            step = seconds*100*(self.speed[n] or 60)
            self.at[n] = min(max(self.goal[n], at-step), at+step)
        command, n, *value = data
        if command == 0x84: self.goal[n] = value[0]+128*value[1]
        if command == 0x87: self.speed[n] = value[0]+128*value[1]
        if command == 0x90: self.answer = round(self.at[n]).to_bytes(2, 'little')
        return len(data)

    def read(self, count: int, /) -> bytes: return self.answer[:count]


class ServoGimbal(Gimbal):
    "Channel 0 of the board is pitch, channel 1 is yaw"
    information = GimbalInformation(vendor='Examples', model='Two servos', pitch=LIMITS['pitch'], yaw=LIMITS['yaw'])
    locks = ()              # no gyroscope: it can hold no direction on earth
    channels = dict(pitch=0, yaw=1)

    def __init__(self, port: Port) -> None:
        super().__init__()
        self.port, self.port_lock = port, threading.Lock()

    def send(self, command: int, channel: int, value: int) -> None:
        self.port.write(bytes([command, channel, value % 128, value//128]))

    def angle(self, axis: str) -> float:
        "Where a servo is, degrees"
        with self.port_lock:
            self.port.write(bytes([0x90, self.channels[axis]]))
            answer = self.port.read(2)
        if len(answer) < 2: raise GimbalError('the Maestro does not answer')
        return (int.from_bytes(answer, 'little')-CENTRE)/DEGREE

    def attitude(self) -> GimbalAttitude:
        q, now = quaternion(0, self.angle('pitch'), self.angle('yaw')), self.setpoint
        return GimbalAttitude(q, vehicle_yaw=self.heading, lock=now.lock, mode=now.mode, time=self.clock())

    def goal(self, axis: str, target: Axis) -> float:
        "The angle to go to: a turn goes to the limit on its side, and one without angle and rate stops here"
        low, high = LIMITS[axis]
        if target.turning and target.rate: return high if target.rate > 0 else low
        return min(max(float(target.angle) if target.angle == target.angle else self.angle(axis), low), high)

    def drive(self, setpoint: Setpoint) -> None:
        for axis, channel in self.channels.items():
            target: Axis = getattr(setpoint, axis)
            goal, rate = self.goal(axis, target), abs(target.rate) if target.rate == target.rate else 0.
            with self.port_lock:
                self.send(0x87, channel, round(rate*DEGREE/100))        # speed: a quarter of a microsecond each 10 ms
                self.send(0x84, channel, round(CENTRE+goal*DEGREE))


def main(connection: str = 'udpout:127.0.0.1:14550', device: str = '') -> None:
    port = serial.Serial(device, timeout=1) if device else SimPort()
    with ServoGimbal(port) as gimbal, MAVCom(connection, source_system=1) as vehicle:
        server = vehicle.add_component(GimbalServer(gimbal=gimbal))
        print(f'{gimbal.information.model} are served at 1/{server.source_component} on {connection}', flush=True)
        try: threading.Event().wait()
        except KeyboardInterrupt: print(f'pitch {gimbal.attitude().pitch:.0f}, yaw {gimbal.attitude().yaw:.0f}')


if __name__ == '__main__': run(main)
