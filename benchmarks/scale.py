"""Many cameras and gimbals in one process, twenty ground stations, and attitude a hundred times a second from each gimbal. See README.md."""
import argparse, json, os, select, socket, statistics, struct, sys, time, traceback
from collections import Counter
from pathlib import Path

os.environ['MAVLINK20'] = '1'
from trees import HERE
from contenders import RELAY, in_background, obey

STATIONS = 20                       # one of them is our `GimbalClient`, the others are sockets
ATTITUDE = 285                      # GIMBAL_DEVICE_ATTITUDE_STATUS
LAYOUTS = ('one system','a system each')

def members(n, layout):
    "`[(port, cameras' and gimbals' addresses)]` of `n` cameras and `n` gimbals; ports count from 0"
    if layout=='one system': return [(0, [(1,10+k) for k in range(n)], [(1,120+k) for k in range(n)])]
    return [(k, [(1+k,100)], [(1+k,154)]) for k in range(n)]

# servers ------------------------------------------------------------------------------------------------------------------------------

class Gimbal:
    "A gimbal that costs nothing itself"
    def __init__(self):
        from UAV.gimbals.values import GimbalAttitude, GimbalInformation
        self.information,self.at = GimbalInformation(model='Bench'),GimbalAttitude(q=(1.,0.,0.,0.), rates=(0.,0.,0.))
    def attitude(self): return self.at

def uav(port, n, layout, **options):
    "Our servers, with their default streams: attitude ten times a second, the manager's status five times, to all; but where each station asks for its own"
    from UAV.mavlink import CameraServer, GimbalServer, MAVCom
    from UAV.mavlink.camera_server import FakeCamera
    GimbalServer.min_interval = 10_000
    for place,cameras,gimbals in members(n, layout):
        com = MAVCom(f'udpin:127.0.0.1:{port+place}', source_system=cameras[0][0])
        for _,number in cameras: com.add_component(CameraServer(number, camera=FakeCamera()))
        for _,number in gimbals: com.add_component(GimbalServer(number, gimbal=Gimbal(), **options))
    obey(more=more)

def more():
    "Memory, MB, and threads"
    import psutil
    p = psutil.Process()
    return dict(rss=p.memory_info().rss/2**20, threads=p.num_threads())

class Loop:
    "One system of the pymavlink loop: its socket, its peers, and an encoder for each component"
    def __init__(self, port, cameras, gimbals):
        from pymavlink.dialects.v20 import ardupilotmega as mavlink
        self.sock,self.peers = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),{}
        self.sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4<<20)
        self.sock.bind(('127.0.0.1', port))
        self.sock.setblocking(False)
        self.mavs = {a: mavlink.MAVLink(None, *a) for a in cameras+gimbals}
        self.gimbals,self.parser,self.mavlink = [self.mavs[a] for a in gimbals],mavlink.MAVLink(None),mavlink
        self.parser.robust_parsing = True

    def pack(self, mav, msg):
        frame = msg.pack(mav)
        mav.seq = (mav.seq+1)%256
        return frame

    def read(self):
        "Take what came: peers, and commands, which are answered"
        while True:
            try: data,peer = self.sock.recvfrom(65535)
            except BlockingIOError: return
            self.peers[peer] = True
            msg = self.parser.parse_char(data)
            if msg is None or msg.get_type()!='COMMAND_LONG' or (msg.target_system,msg.target_component) not in self.mavs: continue
            mav = self.mavs[msg.target_system,msg.target_component]
            ack = mav.command_ack_encode(msg.command, 3, 0, 0, msg.get_srcSystem(), msg.get_srcComponent())
            self.sock.sendto(self.pack(mav, ack), peer)

    def attitudes(self, to_each, boot):
        "Send the attitude of each gimbal, packed once for all peers or once for each"
        for mav in self.gimbals:
            def frame(): return self.pack(mav, mav.gimbal_device_attitude_status_encode(0, 0, int((time.monotonic()-boot)*1000), 12, [1,0,0,0], 0, 0, 0, 0, 0, 0, 0))
            packed = None if to_each else frame()
            for peer in self.peers: self.sock.sendto(packed or frame(), peer)

    def beat(self):
        for mav in self.mavs.values():
            frame = self.pack(mav, mav.heartbeat_encode(26, 8, 0, 0, 4))
            for peer in self.peers: self.sock.sendto(frame, peer)

def pymavlink(port, n, layout, rate=10., to_each=False):
    "What one would write with pymavlink alone: one loop that reads, sends and answers; what it cannot keep up with it leaves out"
    loops,state = [Loop(port+place, cameras, gimbals) for place,cameras,gimbals in members(n, layout)],dict(rate=rate, to_each=to_each)
    boot = time.monotonic()-1
    def run():
        due = beat = time.monotonic()
        while True:
            now = time.monotonic()
            ready,_,_ = select.select([l.sock for l in loops], [], [], max(0, due-now))
            for l in loops:
                if l.sock in ready: l.read()
            if (now := time.monotonic())<due: continue
            for l in loops: l.attitudes(state['to_each'], boot)
            if now>=beat:
                beat += 1
                for l in loops: l.beat()
            due += 1/state['rate']*max(1, int((now-due)*state['rate']))
    in_background(run)
    obey(more=more, set=lambda **how: state.update(how))

# ground stations ----------------------------------------------------------------------------------------------------------------------

class Station:
    "A ground station that costs little: it beats, asks, and counts what comes"
    def __init__(self, number):
        from pymavlink.dialects.v20 import ardupilotmega as mavlink
        self.sock,self.mav = socket.socket(socket.AF_INET, socket.SOCK_DGRAM),mavlink.MAVLink(None, 200+number, 190)
        self.sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4<<20)
        self.sock.bind(('127.0.0.1', 0))
        self.sock.setblocking(False)
        self.forget()

    def forget(self): self.counts,self.steps,self.next,self.ages,self.beats,self.gap = Counter(),[0,0],{},[],{},0.

    def send(self, msg, port):
        self.sock.sendto(msg.pack(self.mav), ('127.0.0.1', port))
        self.mav.seq = (self.mav.seq+1)%256

    def read(self, most=64):
        counts,data = self.counts,b''
        for _ in range(most):
            try: data = self.sock.recv(512)
            except BlockingIOError: break
            key,seq = data[5:7],data[4]
            if data[7:10]==b'\x1d\x01\0': counts[key] += 1
            elif data[7:10]==b'\0\0\0': self.beat(key)
            was = self.next.get(key)
            if was is not None and seq!=was: self.steps[1] += (seq-was)&255
            self.next[key] = (seq+1)&255
            self.steps[0] += 1
        if data[7:10]==b'\x1d\x01\0' and len(self.ages)<100_000:
            self.ages.append((int(time.monotonic()*1000)-struct.unpack('<I', data[10:14])[0])&0xffffffff)

    def beat(self, key):
        now = time.monotonic()
        self.gap,self.beats[key] = max(self.gap, now-self.beats.get(key, now)),now

def dropped(socks):
    "Datagrams for these sockets that found their buffers full, by the kernel's count"
    ports = {f'{s.getsockname()[1]:04X}' for s in socks}
    rows = [line.split() for line in Path('/proc/net/udp').read_text().splitlines()[1:]]
    return sum(int(row[-1]) for row in rows if row[1].split(':')[1] in ports)

def stations(port, n, layout):
    "All stations but ours"
    from pymavlink.dialects.v20 import ardupilotmega as mavlink
    all_of,places = [Station(k) for k in range(STATIONS-1)],members(n, layout)
    ready = select.epoll()
    for s in all_of: ready.register(s.sock, select.EPOLLIN)
    by_fd,state = {s.sock.fileno(): s for s in all_of},dict(drops=0, since=0.)
    def beats():
        while True:
            for s in all_of:
                for place,_,_ in places: s.send(s.mav.heartbeat_encode(6, 8, 0, 0, 4), port+place)
            time.sleep(1)
    def reads():
        while True:
            for fd,_ in ready.poll(): by_fd[fd].read()
    def ask(rate, to_each):
        for place,_,gimbals in places:
            for target in gimbals:
                for s in all_of:
                    s.send(s.mav.command_long_encode(*target, mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 0, ATTITUDE, 1e6/rate if rate else -1, 0, 0, 0, 0, int(to_each)), port+place)
                time.sleep(.01)
    def begin():
        for s in all_of: s.forget()
        state.update(drops=dropped([s.sock for s in all_of]), since=time.monotonic())
    def end():
        s = time.monotonic()-state['since']
        pairs = sorted(a.counts.get(bytes(g), 0)/s for a in all_of for _,_,gimbals in places for g in gimbals)
        seen,missing = (sum(a.steps[k] for a in all_of) for k in (0,1))
        ages = [age for a in all_of for age in a.ages] or [0]
        low = min(ages)             # the clocks of the programs begin at times of their own
        ages = sorted((age-low)&0xffffffff for age in ages)
        return dict(delivered=sum(pairs), least=pairs[len(pairs)//100], most=pairs[-1-len(pairs)//100], frames=seen/s, seeming=missing/max(1, missing+seen),
                    dropped=dropped([a.sock for a in all_of])-state['drops'], age=ages[int(.9*len(ages))], beat_gap=max(a.gap for a in all_of))
    in_background(beats); in_background(reads)
    obey(ask=ask, begin=begin, end=end)

def client(port, n, layout):
    "Our station: a `GimbalClient` that gets the streams as well, and sends a command to one component after the other"
    import asyncio
    from UAV.mavlink import GimbalClient, MAVCom
    loop,places = asyncio.new_event_loop(),members(n, layout)
    com = MAVCom(f'udpout:127.0.0.1:{port}', source_system=255)
    for place,_,_ in places[1:]: com.add_link(f'udpout:127.0.0.1:{port+place}')
    station = com.add_component(GimbalClient(190))
    targets = [a for _,cameras,gimbals in places for a in cameras+gimbals]
    gimbals = [g for _,_,some in places for g in some]
    def ask(rate, to_each):
        async def each(): await asyncio.gather(*[station.send_command(*g, 511, [ATTITUDE, 1e6/rate if rate else -1, 0, 0, 0, 0, int(to_each)]) for g in gimbals])
        loop.run_until_complete(each())
    def run(seconds):
        async def commands():
            times,lost,copies,until,k = [],0,0,time.monotonic()+seconds,0
            while time.monotonic()<until:
                t = time.perf_counter()
                ack = await station.send_command(*targets[k*7%len(targets)], RELAY, [0,1])
                times.append(time.perf_counter()-t)
                k,lost,copies = k+1,lost+(ack.result is None),copies+ack.copies-1
                await asyncio.sleep(.01)
            times.sort()
            return dict(p50=1e6*times[len(times)//2], p90=1e6*times[int(.9*len(times))], worst=1e6*times[-1], unanswered=lost, again=copies, commands=len(times))
        return loop.run_until_complete(commands())
    heard = lambda: len([a for a in targets if a in com.remotes])
    obey(loop, ask=ask, run=run, heard=heard)

# measuring ----------------------------------------------------------------------------------------------------------------------------

def measure(contender, n, layout, way, seconds):
    "One server with its stations, each a process of its own: the server has the first core, all others the second"
    from run import Worker as Process, CORES, free_ports
    class Worker(Process): script = HERE/'scale.py'
    kind,tree = contender
    port,workers = free_ports(1 if layout=='one system' else n),[]
    rate,to_each = WAYS[way]
    how = dict(port=port, n=n, layout=layout)
    try:
        server = Worker(kind, tree=tree, **how, **(dict(attitude_rate=0) if to_each and kind=='uav' else {}))
        workers.append(server)
        crowd = Worker('stations', tree=tree, **how)
        workers.append(crowd)
        ours_ = Worker('client', tree=tree, **how)
        workers.append(ours_)
        server.pin(CORES[:1])
        for w in workers[1:]: w.pin(CORES[-1:])
        until = time.monotonic()+30
        while ours_.ask('heard')<2*n and time.monotonic()<until: time.sleep(.2)
        if kind=='pymavlink': server.ask('set', rate=rate or 10., to_each=to_each)
        elif rate:
            crowd.ask('ask', rate=rate, to_each=to_each)
            if to_each: ours_.ask('ask', rate=rate, to_each=to_each)
        time.sleep(1)
        server.pin(CORES[:1])           # its threads begin with its streams
        was,first = server.ask('more'),server.ask('facts')
        crowd.ask('begin')
        asked = ours_.ask('run', seconds=seconds)
        got,last,now = crowd.ask('end'),server.ask('facts'),server.ask('more')
    finally:
        for w in reversed(workers): w.close()
    s,cpu = last['at']-first['at'],last['cpu']-first['cpu']
    return dict(cpu=100*cpu/s, each=1e6*cpu/s/max(1, (got['frames']+got['dropped']/s)*STATIONS/(STATIONS-1)), wakeups=(last['wakeups']-first['wakeups'])/s, rss=now['rss'], grown=now['rss']-was['rss'],
                threads=now['threads'], **got, **asked)

WAYS = {'as started': (None,False), '100 Hz to all': (100.,False), '100 Hz to each': (100.,True)}

def plan(quick):
    "`[(layout, way, n)]` of all that is measured"
    sizes = (1,10) if quick else (1,10,25,50)
    found = [('one system', way, n) for way in WAYS for n in sizes]
    return found+[('a system each', way, n) for way in list(WAYS)[:2] for n in sizes[-1:]]

def straight(points, key):
    "The slope of `key` over the numbers of cameras, by least squares"
    return statistics.linear_regression([p['n'] for p in points], [p[key] for p in points]).slope

def growth(points):
    "What a camera with its gimbal costs, and by how much the last ones cost more than the first: 1 is a straight line; of points where all that was asked for came"
    points = sorted((p for p in points if p['delivered']>.95*p['asked']), key=lambda p: p['n'])
    if len(points)<2: return {}
    found = dict(upto=points[-1]['n'], **{key: straight(points, key) for key in ('cpu','rss','threads')})
    if len(points)<3: return found
    def step(a, b): return (b['cpu']-a['cpu'])/(b['n']-a['n'])
    return dict(found, bend=step(points[-2], points[-1])/max(1e-9, step(points[0], points[-2])))

def main():
    from run import in_turn, machine, middle, ratio, short, write
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--before', type=Path, help='an older checkout, measured as well')
    parser.add_argument('--quick', action='store_true', help='few and short: to see that it works, not to quote')
    parser.add_argument('--rounds', type=int, help='how often each is measured (3)')
    parser.add_argument('--only', help='a way, such as "100 Hz to all"; writes nothing without --out')
    parser.add_argument('--largest', type=int, help='no more cameras than this')
    parser.add_argument('--out', help='where the results go (scale.json)')
    args = parser.parse_args()
    if args.before and not (args.before/'UAV').is_dir(): parser.error(f'{args.before} has no UAV')
    rounds,seconds = args.rounds or (1 if args.quick else 3),2. if args.quick else 6.
    who = {'UAV': ('uav',None), 'pymavlink': ('pymavlink',None), **({'UAV before': ('uav',str(args.before))} if args.before else {})}
    results = dict(machine=machine(args.before), load=[os.getloadavg()[0]], quick=args.quick, stations=STATIONS, rows=[], growth=[])
    for layout,way,n in plan(args.quick):
        if args.only not in (None, way) or n>(args.largest or n): continue
        got = in_turn(who, rounds, lambda c: measure(c, n, layout, way, seconds))
        for name,found in got.items():
            row = dict(who=name, layout=layout, way=way, n=n, asked=n*(STATIONS-1)*(WAYS[way][0] or 10.), **middle(found))
            if name!='pymavlink': row.update(ratio=ratio(found, got['pymavlink'], 'each'), latency=ratio(found, got['pymavlink']))
            results['rows'].append(row)
            print(json.dumps({k: v if isinstance(v, (str,dict)) else short(v) for k,v in row.items()}), flush=True)
    for layout,way in dict.fromkeys((l,w) for l,w,_ in plan(args.quick)):
        for name in who:
            points = [r for r in results['rows'] if (r['who'],r['layout'],r['way'])==(name,layout,way)]
            if len(points)>1: results['growth'].append(dict(who=name, layout=layout, way=way, **{k: short(v) for k,v in growth(points).items()}))
    for g in results['growth']: print(json.dumps(g))
    results['load'].append(os.getloadavg()[0])
    if args.out or not (args.only or args.largest): write(args.out or HERE/'scale.json', results)

if __name__=='__main__':
    kinds = dict(uav=uav, pymavlink=pymavlink, stations=stations, client=client)
    if len(sys.argv)>1 and sys.argv[1] in kinds:
        try: kinds[sys.argv[1]](**json.loads(sys.argv[2]))
        except BaseException: traceback.print_exc()
        finally: os._exit(1)            # `obey` does not return
    main()
