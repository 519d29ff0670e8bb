"""`examples/serve_my_gimbal.py`, written with pymavlink: what a ground station needs to find, take and point it; no rates, no guard."""
import math, os, sys, time
os.environ['MAVLINK20'] = '1'
from pathlib import Path

from pymavlink import mavutil
from pymavlink.quaternion import QuaternionBase

sys.path.insert(0, str(Path(__file__).parents[2]/'examples'))
from serve_my_gimbal import CENTRE, DEGREE, LIMITS, SimPort         # the board, simulated

mav = mavutil.mavlink
ME, CHANNELS = 154, dict(pitch=0, yaw=1)
FLAGS = mav.GIMBAL_MANAGER_CAP_FLAGS_HAS_PITCH_AXIS | mav.GIMBAL_MANAGER_CAP_FLAGS_HAS_YAW_AXIS | mav.GIMBAL_MANAGER_CAP_FLAGS_HAS_YAW_FOLLOW
STATE = mav.GIMBAL_DEVICE_FLAGS_YAW_IN_VEHICLE_FRAME


class Gimbal:
    def __init__(self, connection, port):
        self.link = mavutil.mavlink_connection(connection, source_system=1, source_component=ME)
        self.port, self.owner, self.every, self.due = port, (0, 0), {}, {}
        self.began = time.monotonic()
        self.sends = {mav.MAVLINK_MSG_ID_HEARTBEAT: self.heartbeat, mav.MAVLINK_MSG_ID_GIMBAL_MANAGER_INFORMATION: self.manager,
                      mav.MAVLINK_MSG_ID_GIMBAL_MANAGER_STATUS: self.status, mav.MAVLINK_MSG_ID_GIMBAL_DEVICE_INFORMATION: self.device,
                      mav.MAVLINK_MSG_ID_GIMBAL_DEVICE_ATTITUDE_STATUS: self.attitude}
        for number, seconds in ((0, 1), (mav.MAVLINK_MSG_ID_GIMBAL_MANAGER_STATUS, .2), (mav.MAVLINK_MSG_ID_GIMBAL_DEVICE_ATTITUDE_STATUS, .1)):
            self.every[number], self.due[number] = seconds, 0

    def ms(self): return int(1e3*(time.monotonic()-self.began))
    def limits(self): return [0, 0]+[math.radians(x) for axis in ('pitch', 'yaw') for x in LIMITS[axis]]
    def heartbeat(self): self.link.mav.heartbeat_send(mav.MAV_TYPE_GIMBAL, mav.MAV_AUTOPILOT_INVALID, 0, 0, mav.MAV_STATE_ACTIVE)
    def manager(self): self.link.mav.gimbal_manager_information_send(self.ms(), FLAGS, ME, *self.limits())
    def status(self): self.link.mav.gimbal_manager_status_send(self.ms(), STATE, ME, *self.owner, 0, 0)

    def device(self):
        self.link.mav.gimbal_device_information_send(self.ms(), b'Examples', b'Two servos', b'', 1, 1, 0, FLAGS, 0, *self.limits(), ME)

    def attitude(self):
        q = QuaternionBase([0, math.radians(self.angle('pitch')), math.radians(self.angle('yaw'))])
        self.link.mav.gimbal_device_attitude_status_send(0, 0, self.ms(), STATE, list(q.q), math.nan, math.nan, math.nan, 0)

    def angle(self, axis):
        self.port.write(bytes([0x90, CHANNELS[axis]]))
        answer = self.port.read(2)
        if len(answer) < 2: raise OSError('the Maestro does not answer')
        return (int.from_bytes(answer, 'little')-CENTRE)/DEGREE

    def point(self, axis, angle):
        if math.isnan(angle): return
        low, high = LIMITS[axis]
        pulse = round(CENTRE+min(max(angle, low), high)*DEGREE)
        self.port.write(bytes([0x84, CHANNELS[axis], pulse % 128, pulse//128]))

    def obey(self, msg):
        "The result of a command"
        sender = msg.get_srcSystem(), msg.get_srcComponent()
        if msg.command == mav.MAV_CMD_REQUEST_MESSAGE:
            if int(msg.param1) not in self.sends: return mav.MAV_RESULT_UNSUPPORTED
            self.due[int(msg.param1)] = 0
        elif msg.command == mav.MAV_CMD_SET_MESSAGE_INTERVAL:
            if int(msg.param1) not in self.sends: return mav.MAV_RESULT_UNSUPPORTED
            self.every[int(msg.param1)] = msg.param2/1e6
        elif msg.command == mav.MAV_CMD_DO_GIMBAL_MANAGER_CONFIGURE:
            wanted = int(msg.param1), int(msg.param2)
            if wanted == (-3, -3): self.owner = (0, 0) if self.owner == sender else self.owner
            elif wanted == (-2, -2): self.owner = sender
            elif wanted != (-1, -1): self.owner = wanted
        elif msg.command == mav.MAV_CMD_DO_GIMBAL_MANAGER_PITCHYAW:
            if self.owner != sender: return mav.MAV_RESULT_DENIED
            for axis, angle in (('pitch', msg.param1), ('yaw', msg.param2)): self.point(axis, angle)
        else: return mav.MAV_RESULT_UNSUPPORTED
        return mav.MAV_RESULT_ACCEPTED

    def run(self):
        while True:
            for number, at in list(self.due.items()):
                if time.monotonic() < at: continue
                try: self.sends[number]()
                except OSError as e: print(e)
                if self.every.get(number, 0) > 0: self.due[number] = time.monotonic()+self.every[number]
                else: del self.due[number]
            msg = self.link.recv_match(type='COMMAND_LONG', blocking=True, timeout=.05)
            if msg is None or msg.target_system not in (0, 1) or msg.target_component not in (0, ME): continue
            try: result = self.obey(msg)
            except OSError: result = mav.MAV_RESULT_FAILED
            self.link.mav.command_ack_send(msg.command, result, 0, 0, msg.get_srcSystem(), msg.get_srcComponent())


def main(connection='udpout:127.0.0.1:14550', device=''):
    import serial
    gimbal = Gimbal(connection, serial.Serial(device, timeout=1) if device else SimPort())
    print(f'Two servos are served at 1/{ME} on {connection}', flush=True)
    try: gimbal.run()
    except KeyboardInterrupt: print(f'pitch {gimbal.angle("pitch"):.0f}, yaw {gimbal.angle("yaw"):.0f}')


if __name__ == '__main__': main(*sys.argv[1:])
