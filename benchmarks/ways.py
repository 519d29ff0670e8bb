"""Which functions of ours three things pass through: `python benchmarks/ways.py [image] [frame] [press] [--calls|--tree]`.

* image: a picture, from the datagram with `IMAGE_START_CAPTURE` to the idle camera
* frame: a picture of the camera on its way to a viewer of its RTSP stream
* press: a press on the panel's pad, from the browser's request to the gimbal's motor

Of each it prints the calls, the modules, and how often the way goes over into another module. It runs on this tree and on
older ones (`PYTHONPATH=TREE python benchmarks/ways.py`). `--calls` prints each function with its calls, `--tree` who calls whom:
there one looks for what to save.
Calls are those of functions that have a name; timers and heartbeats are left out. Each way is gone several times, and
the shortest one counts, because what else the program does at the same time comes on top."""
import http.client, json, os, socket, sys, threading, time
from collections import Counter, defaultdict
from contextlib import ExitStack
from urllib.parse import urlsplit

os.environ['MAVLINK20'] = '1'
import numpy as np
from pymavlink.dialects.v20 import ardupilotmega

from UAV.cameras import Camera, CameraInformation, Frame
from UAV.gimbals import Gimbal, GimbalAttitude, GimbalInformation
from UAV.mavlink import CameraClient, CameraServer, GimbalClient, GimbalServer, MAVCom, mavlink

LONGEST = 20        # s for anything that is waited for
TIMES = 9           # how often a way is gone


def is_ours(frame): return frame.f_globals.get('__name__', '').startswith('UAV.') and frame.f_code.co_name[0]!='<'


class Calls:
    "The calls of ours in all threads while `on`: `{thread: [(module, function)]}`; with `tree` also how deep each one is"
    def __init__(self, tree=False):
        self.on,self.found,self.tree,self.depths = False,defaultdict(list),tree,defaultdict(list)
        threading.setprofile(self.note)

    def note(self, frame, event, arg):
        if not self.on or event!='call': return
        module,name = frame.f_globals.get('__name__', ''),frame.f_code.co_name
        if not is_ours(frame): return
        thread = threading.current_thread().name
        self.found[thread].append((module, name))
        if not self.tree: return
        self.depths[thread].append(0)
        while frame := frame.f_back: self.depths[thread][-1] += is_ours(frame)

    def __enter__(self):
        self.found,self.depths,self.on = defaultdict(list),defaultdict(list),True
        return self

    def __exit__(self, *args): self.on = False

    def kept(self):
        "The calls by thread, without those that come by the clock"
        return [calls for name,calls in list(self.found.items()) if not name.startswith(('timer','MainThread'))]

    def numbers(self, share=1):
        "Calls, modules and changes of module; of one of `share` equal things"
        kept = self.kept()
        changes = sum(a[0]!=b[0] for calls in kept for a,b in zip(calls, calls[1:]))
        return [round(sum(map(len, kept))/share), len({module for calls in kept for module,_ in calls}), round(changes/share)]

    def lines(self):
        "A line for each call, indented by how deep it is"
        return [f'{"  "*depth}{module} {name}' for thread,calls in self.found.items() if calls in self.kept()
                for depth,(module,name) in zip(self.depths[thread], calls)]

    def by_name(self): return Counter(call for calls in self.kept() for call in calls)


def until(test, seconds=LONGEST):
    "Wait until `test` comes true"
    end = time.monotonic()+seconds
    while not test():
        if time.monotonic()>end: raise TimeoutError(f'it took more than {seconds} s')
        time.sleep(.005)


class Dark(Camera):
    "A camera of black pictures, which cost nothing"
    information,image,number,frame_rate = CameraInformation('UAV', 'Dark'),np.zeros((48,64,3), np.uint8),0,20.
    def read(self):
        self.number += 1
        return Frame(self.image, self.number, time.time())


class Motor(Gimbal):
    "A gimbal whose motor notes when it was told"
    information,told = GimbalInformation('UAV', 'Motor'),None
    def __init__(self):
        super().__init__()
        self.moved = threading.Event()
        self.heard = lambda: None
    def drive(self, setpoint):
        self.heard()
        self.moved.set()
    def attitude(self): return GimbalAttitude()


class Ground:
    "A ground station that is none of ours: a socket and pymavlink"
    def __init__(self, port):
        self.sock,self.mav = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),ardupilotmega.MAVLink(None, 255, 190)
        self.sock.connect(('127.0.0.1', port))

    def shoot(self):
        self.send(self.mav.command_long_encode(222, 22, mavlink.MAV_CMD_IMAGE_START_CAPTURE, 0, 0, 0, 1, 0, 0, 0, 0))

    def beat(self): self.send(self.mav.heartbeat_encode(mavlink.MAV_TYPE_GCS, 8, 0, 0, 4))
    def send(self, msg):
        self.sock.send(msg.pack(self.mav))
        self.mav.seq = (self.mav.seq+1)%256     # as pymavlink's own `send` does: else each frame seems to come again


def image(calls):
    "One picture, as often as `TIMES`: the numbers of each, and what was called"
    with Dark() as camera, MAVCom('udpin:127.0.0.1:0', source_system=222) as vehicle:
        vehicle.add_component(CameraServer(22, camera=camera))
        ground = Ground(vehicle.link.port)
        ground.beat()
        for n in range(TIMES):
            ground.beat()
            time.sleep(.2)
            with calls:
                ground.shoot()
                until(lambda: len(camera.pictures)>n)
                camera.wait_idle(LONGEST)
                time.sleep(.1)                  # what is still to be sent
            yield calls.numbers(),calls.by_name()


def watch(uri):
    "A viewer of an RTSP stream over its TCP connection: the socket, after PLAY"
    url = urlsplit(uri)
    sock = socket.create_connection((url.hostname, url.port), LONGEST)
    session,n = '',0
    for method,path,more in (('DESCRIBE','',''), ('SETUP','/track1','Transport: RTP/AVP/TCP;unicast;interleaved=0-1\r\n'), ('PLAY','','')):
        n += 1
        sock.sendall(f'{method} {uri}{path} RTSP/1.0\r\nCSeq: {n}\r\n{session}{more}\r\n'.encode())
        answer = sock.recv(1<<16).decode('latin-1')
        if ' 200 ' not in answer.split('\r\n')[0]: raise ConnectionError(answer)
        if 'Session:' in answer: session = 'Session: '+answer.split('Session:')[1].split('\r\n')[0].split(';')[0].strip()+'\r\n'
    return sock


def frame(calls):
    "Pictures on their way to a viewer: the numbers of one of them"
    with Dark() as camera:
        stream = camera.add_stream(port=0, host='127.0.0.1', rate=camera.frame_rate)
        with watch(stream.uri()) as sock:
            ended = threading.Event()
            def read():
                try:
                    while not ended.is_set() and sock.recv(1<<16): pass
                except OSError: pass
            reader = threading.Thread(target=read, daemon=True)
            reader.start()
            until(lambda: camera.number>10)
            for _ in range(3):
                begun = camera.number
                with calls: until(lambda: camera.number>=begun+20)
                yield calls.numbers(camera.number-begun),calls.by_name()
            ended.set()


def panel(calls, parts):
    "The panel of a vehicle with a gimbal: `(motor, act)`, where `act` sends a press as a page does"
    from UAV.manager import Gui
    motor = parts.enter_context(Motor())
    vehicle,ground = parts.enter_context(MAVCom('virtual:panel', source_system=222)),parts.enter_context(MAVCom('virtual:panel', source_system=255))
    vehicle.add_component(GimbalServer(gimbal=motor))
    gui = parts.enter_context(Gui(ground.add_component(CameraClient(190)), ground.add_component(GimbalClient(191, mavlink.MAV_TYPE_GCS))))
    url = urlsplit(parts.enter_context(gui.serve()).url)
    page = http.client.HTTPConnection(url.hostname, url.port, timeout=LONGEST)
    headers = {'X-Token': url.fragment.removeprefix('token='), 'Content-Type': 'application/json'}
    def act(what, **args):
        page.request('POST', '/act', json.dumps(dict(do=what, of=gimbal, args=args)), headers)
        answer = page.getresponse()
        return json.loads(answer.read() or b'{}')
    def gimbals():
        page.request('GET', '/status', headers=headers)
        return [row['id'] for row in json.loads(page.getresponse().read())['gimbals']]
    until(gimbals)
    gimbal = gimbals()[0]
    time.sleep(1)                               # the panel learns what it is
    return motor,act


def press(calls):
    "A press on the pad, and the motor's word"
    with ExitStack() as parts:
        motor,act = panel(calls, parts)
        for n in range(TIMES+1):
            motor.moved.clear()
            motor.heard = lambda: setattr(calls, 'on', False)
            with calls:
                act('hold', pitch=5., yaw=10.+n, hold=f'h{n}', n=0)
                if not motor.moved.wait(LONGEST): raise TimeoutError('the motor was not told')
            numbers,names = calls.numbers(),calls.by_name()
            motor.heard = lambda: None
            act('release', hold=f'h{n}')
            if n: yield numbers,names           # the first one takes control, too
            time.sleep(.1)


WAYS = dict(image=image, frame=frame, press=press)


def measure(way, calls):
    "The shortest of several: its calls, modules and changes, the calls by name, and the tree of calls"
    found = ((*once, calls.lines()) for once in WAYS[way](calls))
    return min(found, key=lambda found: found[0][0])


def main():
    words = sys.argv[1:]
    calls,found = Calls('--tree' in words),{}
    for way in [w for w in WAYS if w in words] or WAYS:
        numbers,names,lines = measure(way, calls)
        print(*lines, sep='\n', end='\n'*bool(lines))
        found[way] = numbers
        if '--calls' in words: print(way, *numbers, *(f'\n{n:5} {module}.{name}' for (module,name),n in names.most_common()))
    print(json.dumps(found), flush=True)
    os._exit(0)


if __name__=='__main__': main()
