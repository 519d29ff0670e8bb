"""The processes that `run.py` and `soak.py` start: servers, clients, a telemetry sender. They are told what to do in lines of JSON."""
import os
os.environ['MAVLINK20'] = '1'
import json, random, resource, socket, statistics, sys, threading, time, traceback
from concurrent.futures import ThreadPoolExecutor

from trees import ours
VEHICLE,GROUND = (1,1),(255,190)      # (system, component) of every server and every client
RELAY = 181                           # MAV_CMD_DO_SET_RELAY: all contenders can send it, and it has one answer

# what every process can do ------------------------------------------------------------------------------------------------------------

def facts():
    "What this process, all its threads, has used so far: CPU (user+system, s), wake-ups; and when"
    return dict(cpu=time.process_time(), wakeups=resource.getrusage(resource.RUSAGE_SELF).ru_nvcsw, at=time.perf_counter())

def obey(loop=None, **verbs):
    "Say that we are ready, and do what the lines on stdin say until it is closed; an event `loop` runs meanwhile"
    out = os.fdopen(os.dup(1), 'w')
    os.dup2(2, 1)                     # what a library prints does not get between our lines
    verbs['facts'] = facts
    def say(what):
        out.write(json.dumps(what)+'\n')
        out.flush()
    say('ready')
    for line in iter(lines(loop), ''):
        verb,args = json.loads(line)
        say(verbs[verb](**args))
    os._exit(0)                       # MAVSDK's asyncio front may hang when it is taken down properly

def lines(loop):
    "A function that gives the next line of stdin, while `loop` does what it has to do"
    if loop is None: return sys.stdin.readline
    reader = ThreadPoolExecutor(1)
    return lambda: loop.run_until_complete(loop.run_in_executor(reader, sys.stdin.readline))

def summary(times, answered, cpu):
    "What is told of a batch of commands; times in s, told in µs"
    times = sorted(times)
    return dict(p50=1e6*statistics.median(times), p90=1e6*times[int(.9*len(times))], cpu=1e6*cpu/len(times), lost=len(times)-answered)

def batches(ask):
    "A function that calls `ask` `n` times and tells how long it took; `ask` is true when it was answered"
    def run(n):
        times,answered,cpu = [],0,time.process_time()
        for _ in range(n):
            t = time.perf_counter()
            answered += bool(ask())
            times.append(time.perf_counter()-t)
        return summary(times, answered, time.process_time()-cpu)
    return run

def awaited(loop, ask):
    "The same for a coroutine function `ask`"
    async def run(n):
        times,answered,cpu = [],0,time.process_time()
        for _ in range(n):
            t = time.perf_counter()
            answered += bool(await ask())
            times.append(time.perf_counter()-t)
        return summary(times, answered, time.process_time()-cpu)
    return lambda n: loop.run_until_complete(run(n))

def in_background(f): threading.Thread(target=f, daemon=True).start()

# ours ---------------------------------------------------------------------------------------------------------------------------------

def vehicle(port, components=1, connection='udpin', links=1):
    "Our server: components 1, 2, … of the vehicle; the first beats as an autopilot, so that MAVSDK takes it for a vehicle"
    from UAV.mavlink import Component, MAVCom, mavlink
    command = ours('command')
    class Relay(Component):
        @command(RELAY)
        def _do_set_relay(self, index:int=0, on:int=0): "Nothing to switch"
    class Autopilot(Relay):
        def beat(self): self.send_message(self.mav.heartbeat_encode(mavlink.MAV_TYPE_QUADROTOR, mavlink.MAV_AUTOPILOT_PX4, 0, 0, mavlink.MAV_STATE_ACTIVE))
    com = MAVCom(f'{connection}:127.0.0.1:{port}', source_system=VEHICLE[0])
    for n in range(1, links): com.add_link(f'{connection}:127.0.0.1:{port+n}')
    com.add_component(Autopilot(1, mavlink.MAV_TYPE_QUADROTOR))
    for n in range(1, components): com.add_component(Relay(1+n, mavlink.MAV_TYPE_GENERIC))
    return com

def uav_server(**how):
    com = vehicle(**how)
    obey(received=lambda: sum(sum(names.values()) for names in com.message_cnts.values()))

def uav_client(port, connection='udpout', component=1, server=False, loop_reads=False):
    "Our client; `server`: in one process with the server it asks. `loop_reads`: inside `async with`, if the tree has that"
    import asyncio
    from UAV.mavlink import Component, MAVCom, mavlink
    if loop_reads and not hasattr(MAVCom, '__aenter__'): raise SystemExit('this tree has no `async with MAVCom`')
    loop = asyncio.new_event_loop()
    coms = [vehicle(port)] if server else []
    coms.append(MAVCom(f'{connection}:127.0.0.1:{port}', source_system=GROUND[0]))
    if loop_reads:
        for com in coms: loop.run_until_complete(com.__aenter__())
    station = coms[-1].add_component(Component(GROUND[1], mavlink.MAV_TYPE_GCS))
    if not loop.run_until_complete(station.wait_heartbeat(target_system=1, target_component=component, timeout=10)): sys.exit('our server does not beat')
    obey(loop, run=awaited(loop, lambda: station.send_command(1, component, RELAY, [0, 1])))

def uav_blocking(port, component=1):
    "Our client for programs without `async`"
    from UAV.blocking import MAVCom
    from UAV.mavlink import Component, mavlink
    com = MAVCom(f'udpout:127.0.0.1:{port}', source_system=GROUND[0])
    station = com.add_component(Component(GROUND[1], mavlink.MAV_TYPE_GCS))
    if not station.wait_heartbeat(target_system=1, target_component=component, timeout=10): sys.exit('our server does not beat')
    obey(run=batches(lambda: station.send_command(1, component, RELAY, [0, 1])))

# pymavlink ----------------------------------------------------------------------------------------------------------------------------

def beat(mav):
    "Beat as an autopilot, once a second"
    while True:
        mav.heartbeat_send(2, 12, 0, 0, 4)
        time.sleep(1)

def loop_server(port):
    "pymavlink as its documentation has it: `recv_match` in a loop"
    from pymavlink import mavutil
    conn = mavutil.mavlink_connection(f'udpin:127.0.0.1:{port}', source_system=VEHICLE[0], source_component=VEHICLE[1])
    def loop():
        while True:
            m = conn.recv_match(type='COMMAND_LONG', blocking=True)
            conn.mav.command_ack_send(m.command, 0, 0, 0, m.get_srcSystem(), m.get_srcComponent())
    in_background(loop); in_background(lambda: beat(conn.mav))
    obey(received=lambda: conn.mav_count)

def loop_client(port):
    from pymavlink import mavutil
    conn = mavutil.mavlink_connection(f'udpout:127.0.0.1:{port}', source_system=GROUND[0], source_component=GROUND[1])
    def ask():
        conn.mav.command_long_send(*VEHICLE, RELAY, 0, 0, 1, 0, 0, 0, 0, 0)
        m = conn.recv_match(type='COMMAND_ACK', blocking=True, timeout=2)
        return m and m.result==0
    obey(run=batches(ask))

def heartbeat_camera(port):
    "A camera that only beats, once a second, and reads what comes"
    from pymavlink import mavutil
    conn = mavutil.mavlink_connection(f'udpin:127.0.0.1:{port}', source_system=1, source_component=100)
    def loop():
        while True: conn.recv_match(blocking=True)
    def beats():
        while True:
            conn.mav.heartbeat_send(30, 8, 0, 0, 4)        # MAV_TYPE_CAMERA, no autopilot
            time.sleep(1)
    in_background(loop); in_background(beats)
    obey()

class Wire:
    "pymavlink's encoder and decoder on a blocking socket: the least that Python can do with them"
    def __init__(self, source):
        from pymavlink.dialects.v20 import ardupilotmega as mavlink
        self.sock,self.peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),None
        self.mav = mavlink.MAVLink(self, *source)
        self.mav.robust_parsing = True
    def write(self, frame):
        if self.peer: self.sock.sendto(frame, self.peer)
    def until(self, name):
        while True:
            data,self.peer = self.sock.recvfrom(65535)
            if (m := self.mav.parse_char(data)) and m.get_type()==name: return m

def tight_server(port):
    wire = Wire(VEHICLE)
    wire.sock.bind(('127.0.0.1', port))
    def loop():
        while True:
            m = wire.until('COMMAND_LONG')
            wire.mav.command_ack_send(m.command, 0, 0, 0, m.get_srcSystem(), m.get_srcComponent())
    in_background(loop); in_background(lambda: beat(wire.mav))
    obey()

def tight_client(port):
    wire = Wire(GROUND)
    wire.peer = '127.0.0.1',port
    wire.sock.settimeout(2)
    def ask():
        wire.mav.command_long_send(*VEHICLE, RELAY, 0, 0, 1, 0, 0, 0, 0, 0)
        return wire.until('COMMAND_ACK').result==0
    obey(run=batches(ask))

# the least there is -------------------------------------------------------------------------------------------------------------------

def handover_server(port):
    "Sends back what comes: no MAVLink"
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sock.bind(('127.0.0.1', port))
    def loop():
        while True: sock.sendto(*sock.recvfrom(65535))
    in_background(loop)
    obey()

def handover_client(port):
    "A thread that reads, an event loop that awaits, and nothing else: what our way of waiting costs by itself"
    import asyncio
    sock,loop,woken = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),asyncio.new_event_loop(),[None]
    def read():
        while True:
            sock.recvfrom(65535)
            loop.call_soon_threadsafe(woken[0].set_result, True)
    async def ask():
        woken[0] = loop.create_future()
        sock.sendto(bytes(45), ('127.0.0.1', port))
        return await woken[0]
    sock.bind(('127.0.0.1', 0))
    in_background(read)
    obey(loop, run=awaited(loop, ask))

def receive_only(port):
    "Takes what comes, and throws it away"
    sock,got = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),[0]
    sock.bind(('127.0.0.1', port))
    def loop():
        while True: sock.recvfrom(65535); got[0] += 1
    in_background(loop)
    obey(received=lambda: got[0])

# MAVSDK -------------------------------------------------------------------------------------------------------------------------------

def mavsdk_asyncio(port):
    "MAVSDK's asyncio front, as its documentation has it"
    import asyncio, mavsdk
    from mavsdk.asyncio import ComponentType, Configuration, Mavsdk
    from mavsdk.asyncio.plugins.action import ActionAsync, ActionResult, RelayCommand
    mavsdk.log_subscribe(lambda *x: True)
    loop,sdk = asyncio.new_event_loop(),Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
    async def connect():
        await sdk.add_any_connection(f'udpout://127.0.0.1:{port}')
        return await sdk.first_autopilot(timeout_s=20)
    action = ActionAsync(loop.run_until_complete(connect()))
    async def ask(): return await action.set_relay(0, RelayCommand.ON)==ActionResult.SUCCESS
    obey(loop, run=awaited(loop, ask))

def mavsdk_blocking(port):
    from mavsdk.plugins.action import Action, ActionResult, RelayCommand
    sdk = ground_station(f'udpout://127.0.0.1:{port}')
    action = Action(sdk.first_autopilot(20))
    obey(run=batches(lambda: action.set_relay(0, RelayCommand.ON)==ActionResult.SUCCESS))

def ground_station(connection):
    import mavsdk
    mavsdk.log_subscribe(lambda *x: True)
    sdk = mavsdk.Mavsdk(mavsdk.Configuration.create_with_component_type(mavsdk.ComponentType.GROUND_STATION))
    sdk.add_any_connection_with_handle(connection)
    return sdk

def mavsdk_listener(port):
    "A ground station that listens, and has subscribed to nothing"
    sdk = ground_station(f'udpin://127.0.0.1:{port}')
    obey(received=lambda: None, vehicles=lambda: len(sdk.get_systems()))

def mavsdk_camera(port):
    "MAVSDK's camera server, with what it says of itself"
    import mavsdk
    from mavsdk.plugins.camera_server import CameraServer, Information
    mavsdk.log_subscribe(lambda *x: True)
    sdk = mavsdk.Mavsdk(mavsdk.Configuration.create_with_component_type(mavsdk.ComponentType.CAMERA))
    sdk.add_any_connection_with_handle(f'udpin://127.0.0.1:{port}')
    server = CameraServer(sdk.server_component())
    server.set_information(Information('MAVSDK', 'Camera', '1.0.0', 3., 3.68, 2.76, 640, 480, 0, 0, '', False, False))
    obey(information=lambda: bool(server))

# what else it takes -------------------------------------------------------------------------------------------------------------------

def telemetry(n=2048):
    "`n` frames of an autopilot, mixed; the first is a heartbeat. 2048 frames, so that the sequence numbers go on when they are sent again"
    from pymavlink.dialects.v20 import ardupilotmega as mavlink
    mav,rng,frames = mavlink.MAVLink(None, *VEHICLE),random.Random(1),[]
    def f(): return rng.uniform(-1, 1)
    def i(k=1): return [rng.randrange(1, 120) for _ in range(k)]
    kinds = [lambda: mav.attitude_encode(*i(), f(), f(), f(), f(), f(), f()),
             lambda: mav.global_position_int_encode(*i(9)),
             lambda: mav.raw_imu_encode(*i(10)),
             lambda: mav.scaled_imu2_encode(*i(10)),
             lambda: mav.vfr_hud_encode(f(), f(), *i(2), f(), f()),
             lambda: mav.local_position_ned_encode(*i(), f(), f(), f(), f(), f(), f()),
             lambda: mav.servo_output_raw_encode(*i(10)),
             lambda: mav.rc_channels_encode(*i(21)),
             lambda: mav.gps_raw_int_encode(*i(10)),
             lambda: mav.sys_status_encode(*i(13)),
             lambda: mav.battery_status_encode(0, 0, 0, 100, i(10), *i(4)),
             lambda: mav.vibration_encode(*i(), f(), f(), f(), *i(3)),
             lambda: mav.nav_controller_output_encode(f(), f(), *i(3), f(), f(), f()),
             lambda: mav.statustext_encode(6, b'EKF3 IMU0 is using GPS')]
    for k in range(n):
        m = mav.heartbeat_encode(2, 12, 0, 0, 4) if k==0 else kinds[k%len(kinds)]()
        frames.append(m.pack(mav))
        mav.seq = (mav.seq+1)%256
    return frames

def sender(ports, rate=2000):
    "Beats to all `ports`; `send` sends mixed telemetry to one of them, one frame a datagram, evenly paced"
    sock,frames = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),telemetry()
    def write(frame, port):
        try: sock.sendto(frame, ('127.0.0.1', port))
        except OSError: pass
    def beats():
        while True:
            for p in ports: write(frames[0], p)
            time.sleep(1)
    in_background(beats)
    def send(port, seconds):
        n,start = int(rate*seconds),time.monotonic()
        for k in range(n):
            wait = start+k/rate-time.monotonic()
            if wait>0: time.sleep(wait)
            write(frames[k%len(frames)], port)
        return n
    obey(send=send)

def crowd(port, n, at):
    "`n` other systems on a server: they beat once a second, and read what they are sent. `at`: 'peers' of one UDP port, TCP 'clients', or one on each of `n` UDP 'links'"
    import selectors
    from pymavlink.dialects.v20 import ardupilotmega as mavlink
    ready,socks = selectors.DefaultSelector(),[]
    for k in range(n):
        sock = socket.socket(socket.AF_INET, socket.SOCK_STREAM if at=='clients' else socket.SOCK_DGRAM)
        sock.connect(('127.0.0.1', port+k if at=='links' else port))
        ready.register(sock, selectors.EVENT_READ)
        socks.append((sock, mavlink.MAVLink(sock.makefile('wb', buffering=0), 2+k, GROUND[1])))
    def beats():
        while True:
            for _,mav in socks: mav.heartbeat_send(6, 8, 0, 0, 4)
            time.sleep(1)
    def reads():
        while True:
            for key,_ in ready.select(): key.fileobj.recv(65536)
    in_background(beats); in_background(reads)
    obey()

def message():
    "What one received message costs, each way of reading it in turn"
    from pymavlink import mavutil
    from pymavlink.dialects.v20 import ardupilotmega as mavlink
    FrameReader,Wanted,frames = ours('FrameReader'),ours('Wanted'),telemetry()[1:]
    def seen(m): return getattr(m, m.fieldnames[0])
    class Replay(mavutil.mavudp):
        "mavutil's UDP connection, reading what we have instead of its socket"
        def recv(self, n=None): return next(self.frames)
    def parser():
        mav = mavlink.MAVLink(None)
        mav.robust_parsing = True
        return mav
    char,buffer,conn = parser(),parser(),Replay('127.0.0.1:0')
    nobody,everybody = FrameReader(Wanted(mavlink.MAVLINK_MSG_ID_COMMAND_LONG)),FrameReader(Wanted(None))
    def parse_char():
        for frame in frames: seen(char.parse_char(frame))
    def recv_msg():
        conn.frames = iter(frames)
        for _ in frames: seen(conn.recv_msg())
    def parse_buffer():
        for frame in frames:
            for m in buffer.parse_buffer(frame): seen(m)
    def feed_unwanted():
        for frame in frames: nobody.feed(frame)
    def feed_wanted():
        for frame in frames:
            for m in everybody.feed(frame): seen(m)
    ways = (feed_unwanted, feed_wanted, parse_char, recv_msg, parse_buffer)
    def run(turn):
        costs = {}
        for f in ways[turn:]+ways[:turn]:
            t,cpu = time.perf_counter(),time.process_time()
            f()
            costs[f.__name__] = dict(p50=1e6*(time.perf_counter()-t)/len(frames), cpu=1e6*(time.process_time()-cpu)/len(frames))
        return costs
    obey(run=run)

if __name__=='__main__':
    try: globals()[sys.argv[1]](**json.loads(sys.argv[2]))
    except BaseException: traceback.print_exc()
    finally: os._exit(1)              # `obey` does not return
