"""What the pymavlink programs of this folder share: a ground station that takes a picture with each camera, and fetches it."""
import itertools, os, re, time
os.environ['MAVLINK20'] = '1'
from pymavlink import mavutil
from pymavlink.mavftp import MAVFTP

mav = mavutil.mavlink


class Refused(RuntimeError): pass


class Station:
    def __init__(self, connection):
        self.link = mavutil.mavlink_connection(connection, source_system=255, source_component=190)
        self.shots = itertools.count(int(time.time()) % 1_000_000)       # another process had other numbers

    def __enter__(self): return self
    def __exit__(self, *_): self.link.close()

    def wait(self, kinds, fits, timeout):
        "The first message that fits, or `None`"
        end = time.monotonic()+timeout
        while (left := end-time.monotonic()) > 0:
            msg = self.link.recv_match(type=kinds, blocking=True, timeout=left)
            if msg and fits(msg): return msg

    def command(self, to, command, *params, tries=5):
        "Send a command again until it is answered; a refusal raises `Refused`"
        def fits(ack): return (ack.get_srcSystem(), ack.get_srcComponent()) == to and ack.command == command
        for confirmation in range(tries):
            self.link.mav.command_long_send(*to, command, confirmation, *params, *[0]*(7-len(params)))
            ack = self.wait('COMMAND_ACK', fits, .5)
            while ack and ack.result == mav.MAV_RESULT_IN_PROGRESS: ack = self.wait('COMMAND_ACK', fits, 5)
            if ack and ack.result: raise Refused(f'command {command}: {mav.enums["MAV_RESULT"][ack.result].name} from {to}')
            if ack: return
        raise TimeoutError(f'{to} does not answer command {command}')

    def request(self, to, number, index=0, tries=3):
        name = mav.mavlink_map[number].msgname
        for _ in range(tries):
            self.link.mav.command_long_send(*to, mav.MAV_CMD_REQUEST_MESSAGE, 0, number, index, 0, 0, 0, 0, 0)
            msg = self.wait(name, lambda m: (m.get_srcSystem(), m.get_srcComponent()) == to, .5)
            if msg: return msg
        raise TimeoutError(f'{to} does not send {name}')

    def find(self, kind, count, timeout=10):
        "The addresses of components of a MAV_TYPE, by their heartbeats"
        found = set()
        def enough(beat):
            if beat.type == kind: found.add((beat.get_srcSystem(), beat.get_srcComponent()))
            return len(found) >= count
        self.wait('HEARTBEAT', enough, timeout)
        return sorted(found)

    def name(self, to):
        info = self.request(to, mav.MAVLINK_MSG_ID_CAMERA_INFORMATION)
        return ' '.join(bytes(text).rstrip(b'\0').decode() for text in (info.vendor_name, info.model_name))

    def shoot(self, to):
        "A number of its own for each picture, so that a retransmission takes no second one"
        self.command(to, mav.MAV_CMD_IMAGE_START_CAPTURE, 0, 0, 1, next(self.shots))
        shot = self.wait('CAMERA_IMAGE_CAPTURED', lambda m: (m.get_srcSystem(), m.get_srcComponent()) == to, 5)
        if shot is None:                            # the notice was lost: ask for the last one
            last = self.request(to, mav.MAVLINK_MSG_ID_CAMERA_CAPTURE_STATUS).image_count-1
            shot = self.request(to, mav.MAVLINK_MSG_ID_CAMERA_IMAGE_CAPTURED, last)
        if shot.capture_result != 1: raise RuntimeError(f'camera {to} could not take the picture')
        return shot

    def fetch(self, to, shot, folder):
        folder.mkdir(parents=True, exist_ok=True)
        path = re.sub(r'^mftp://(\[.*?\])?', '', shot.file_url)
        file, ftp = folder/path.rpartition('/')[2], MAVFTP(self.link, *to)
        ftp.cmd_get([path, str(file)])
        got = ftp.process_ftp_reply('OpenFileRO', timeout=60)
        if got.error_code: raise RuntimeError(f'{path}: error {got.error_code}')
        return file
