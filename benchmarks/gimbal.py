"""Ten minutes on an aircraft: what a gimbal costs that an autopilot steers 50 times a second. See README.md."""
import os
os.environ['MAVLINK20'] = '1'
import argparse, json, math, subprocess, sys, time

from trees import HERE, environment
from contenders import VEHICLE, GROUND, Wire, in_background, obey
from run import Worker, free_ports, machine, write

GIMBAL,AUTOPILOT = (1,154),(1,1)        # (system, component)
DEVICE_INFORMATION,MANAGER_INFORMATION,CONFIGURE = 283,280,1001
NAN,AXES_LOCKED = math.nan,28           # ROLL|PITCH|YAW_LOCK: ArduPilot's flags for a yaw from north
peers = {}                              # the processes that this file can be: `{name: function}`

def peer(f):
    peers[f.__name__] = f
    return f

# the gimbals --------------------------------------------------------------------------------------------------------------------------

def still():
    "A gimbal that costs nothing: what remains is the protocol"
    from UAV.gimbals import Gimbal, GimbalAttitude, GimbalInformation
    class Still(Gimbal):
        information = GimbalInformation(model='Still')
        def drive(self, setpoint): "It has no motors"
        def attitude(self): return GimbalAttitude((1.,0.,0.,0.), (0.,0.,0.), self.heading)
        def retract(self): "Nothing to stow"
    return Still()

@peer
def server(port, role, sim=True):
    "Ours"
    from UAV.gimbals import SimGimbal
    from UAV.mavlink import GimbalServer, MAVCom, mavlink
    com = MAVCom(f'udpin:127.0.0.1:{port}', source_system=VEHICLE[0])
    com.add_component(GimbalServer(mavlink.MAV_COMP_ID_GIMBAL, gimbal=SimGimbal() if sim else still(), role=role))
    obey(received=lambda: sum(sum(names.values()) for names in com.message_cnts.values()))

def device_information(mav):
    return mav.gimbal_device_information_encode(0, b'', b'', b'', 0, 0, 0, 0, 0, -.5, .5, -1.57, .52, -2.8, 2.8)

def attitude_status(mav):
    return mav.gimbal_device_attitude_status_encode(0, 0, 0, 12|32, [1,0,0,0], 0., 0., 0., 0, 0., 0., 0)

def streams(mav):
    "What a bare gimbal sends: its attitude ten times a second, and its heartbeat"
    start = time.monotonic()
    for n in range(10**9):
        if n%10==0: mav.heartbeat_send(26, 8, 0, 0, 4)
        mav.send(attitude_status(mav))
        time.sleep(max(0, start+.1*(n+1)-time.monotonic()))

@peer
def bare(port):
    "pymavlink as its documentation has it: `recv_match` in a loop, and what comes is thrown away"
    from pymavlink import mavutil
    conn = mavutil.mavlink_connection(f'udpin:127.0.0.1:{port}', source_system=GIMBAL[0], source_component=GIMBAL[1])
    def loop():
        while True:
            if conn.recv_match(blocking=True).get_type()=='COMMAND_LONG': conn.mav.send(device_information(conn.mav))
    in_background(loop); in_background(lambda: streams(conn.mav))
    obey(received=lambda: conn.mav_count)

@peer
def tight(port):
    "The least that Python can do with pymavlink: a blocking socket, and one frame of each datagram"
    wire,got = Wire(GIMBAL),[0]
    wire.sock.bind(('127.0.0.1', port))
    def loop():
        while True:
            data,wire.peer = wire.sock.recvfrom(2048)
            m = wire.mav.parse_char(data)
            got[0] += 1
            if m.get_type()=='COMMAND_LONG': wire.mav.send(device_information(wire.mav))
    in_background(loop); in_background(lambda: streams(wire.mav))
    obey(received=lambda: got[0])

# those that steer them ----------------------------------------------------------------------------------------------------------------

class Steering:
    "One end of a link to a gimbal: counts what it says"
    def __init__(self, port, source):
        self.wire,self.heard,self.informed = Wire(source),{},False
        self.wire.peer = '127.0.0.1',port
        self.wire.sock.setblocking(False)

    def send(self, msg): self.wire.mav.send(msg)
    def read(self):
        "All that has come"
        while True:
            try: data = self.wire.sock.recv(2048)
            except BlockingIOError: return
            except ConnectionRefusedError: continue         # it does not listen yet
            for m in self.wire.mav.parse_buffer(data) or []:
                name = m.get_type()
                self.heard[name] = self.heard.get(name, 0)+1
                self.informed |= name in ('GIMBAL_DEVICE_INFORMATION','GIMBAL_MANAGER_INFORMATION')

def quaternion(pitch, yaw):
    (cp,sp),(cy,sy) = ((math.cos(math.radians(a/2)), math.sin(math.radians(a/2))) for a in (pitch, yaw))
    return [cp*cy, -sp*sy, sp*cy, cp*sy]

def setpoints(mav, t):
    "GIMBAL_DEVICE_SET_ATTITUDE as ArduPilot sends it `t` seconds after the start: 40 s angles, 10 s rates and 10 s retract in each minute"
    phase = t%60
    def encode(flags, q, *rates): return mav.gimbal_device_set_attitude_encode(*GIMBAL, flags, q, *rates)
    angles = quaternion(-30+20*math.sin(t/5), 40*math.sin(t/7))
    if phase<20: return [encode(0, angles, NAN, NAN, NAN)]
    if phase<40: return [encode(AXES_LOCKED, angles, NAN, NAN, NAN)]
    if phase<50: return [encode(0, [NAN]*4, 0., math.radians(10*math.sin(t)), math.radians(5))]
    return [encode(1, [NAN]*4, 0., 0., 0.), encode(0, quaternion(0, 0), NAN, NAN, NAN)]      # really both, each time

def vehicle_state(mav, t):
    "AUTOPILOT_STATE_FOR_GIMBAL_DEVICE of a vehicle that turns 3 degrees a second"
    return mav.autopilot_state_for_gimbal_device_encode(1, 0, int(t*1e6), quaternion(0, 3*t), 0, 5., 0., 0., 0, .052, 831, 2, .052)

@peer
def autopilot(ports):
    "In the manner of ArduPilot: finds each gimbal, then 50 states and 50 attitudes a second to each"
    gimbals = [Steering(port, AUTOPILOT) for port in ports]
    def fly():
        start = time.monotonic()
        for n in range(10**9):
            t = .02*n
            for g in gimbals:
                mav = g.wire.mav
                if n%50==0:
                    g.send(mav.heartbeat_encode(2, 3, 81, 0, 4))
                    if not g.informed: g.send(mav.command_long_encode(*GIMBAL, 512, 0, DEVICE_INFORMATION, 0, 0, 0, 0, 0, 0))
                if g.informed:
                    g.send(vehicle_state(mav, t))
                    for m in setpoints(mav, t): g.send(m)
                g.read()
            time.sleep(max(0, start+t+.02-time.monotonic()))
    in_background(fly)
    obey(heard=lambda: [g.heard for g in gimbals], found=lambda: all(g.informed for g in gimbals))

@peer
def station(ports, steers):
    "In the manner of QGroundControl: beats, and with `steers` takes control and sends rates each half second"
    gimbals = [Steering(port, GROUND) for port in ports]
    def work():
        start = time.monotonic()
        for n in range(10**9):
            for g in gimbals:
                mav = g.wire.mav
                if n%10==0: g.send(mav.heartbeat_encode(6, 8, 0, 0, 4))
                if n%10==1 and not g.informed:
                    g.send(mav.command_long_encode(*GIMBAL, 512, 0, MANAGER_INFORMATION, 0, 0, 0, 0, 0, 0))
                    if steers: g.send(mav.command_long_encode(*GIMBAL, CONFIGURE, 0, *GROUND, -1, -1, NAN, NAN, 1))
                if n%5==3 and steers and g.informed:
                    rate = .2*(1 if n%100<50 else -1)
                    g.send(mav.gimbal_manager_set_attitude_encode(*GIMBAL, 4|8|32, 0, [NAN]*4, NAN, rate, rate))
                g.read()
            time.sleep(max(0, start+.1*(n+1)-time.monotonic()))
    in_background(work)
    obey(heard=lambda: [g.heard for g in gimbals], found=lambda: all(g.informed for g in gimbals))

# measuring ----------------------------------------------------------------------------------------------------------------------------

class Process(Worker):
    "A process of this file"
    def __init__(self, kind, **args):
        self.kind = kind
        self.process = subprocess.Popen([sys.executable, __file__, '--peer', kind, json.dumps(args)], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, env=environment())
        if self.hear(60)!='ready': raise SystemExit(f'{kind} did not start')

RUNS = [('bare pymavlink, recv_match', 'bare', {}), ('bare pymavlink, a socket', 'tight', {}),
        ('device, a gimbal without motors', 'server', dict(role='device', sim=False)), ('device, SimGimbal', 'server', dict(role='device')),
        ('both, a gimbal without motors, idle', 'server', dict(role='both', sim=False)),
        ('both, SimGimbal, idle', 'server', dict(role='both')), ('both, SimGimbal, a QGroundControl', 'server', dict(role='both'))]

def wait_found(peers, seconds=20):
    until = time.monotonic()+seconds
    while not all(p.ask('found') for p in peers):
        if time.monotonic()>until: raise SystemExit('a gimbal was not found')
        time.sleep(.2)

def measure(seconds, runs=RUNS):
    "A row for each of `runs`, all at the same time"
    ports = [free_ports() for _ in runs]
    gimbals = [Process(kind, port=port, **how) for port,(_,kind,how) in zip(ports, runs)]
    flying = [p for p,(name,*_) in zip(ports, runs) if 'both' not in name]
    idle,qgc = ([p for p,(name,*_) in zip(ports, runs) if word in name] for word in (', idle',', a QGround'))
    others = [Process('autopilot', ports=flying), Process('station', ports=idle, steers=False), Process('station', ports=qgc, steers=True)]
    try:
        wait_found(others)
        time.sleep(2)
        def facts(): return [(g.ask('facts'), g.ask('received')) for g in gimbals],[p.ask('heard') for p in others],others[0].ask('facts')
        first = facts()
        time.sleep(seconds)
        last = facts()
    finally:
        for p in gimbals+others: p.close()
    counts = [dict(zip(flying+idle+qgc, [h for heard in when for h in heard])) for when in (first[1], last[1])]
    rows = [row(name, *both, *(c[port] for c in counts)) for (name,*_),port,*both in zip(runs, ports, first[0], last[0])]
    (before,after) = first[2],last[2]
    return rows,100*(after['cpu']-before['cpu'])/(after['at']-before['at'])

def row(name, first, last, heard_first, heard_last):
    "What one gimbal has used between two looks at it"
    (a,got_a),(b,got_b) = first,last
    wall,attitudes = b['at']-a['at'],'GIMBAL_DEVICE_ATTITUDE_STATUS'
    return dict(name=name, percent_of_a_core=round(100*(b['cpu']-a['cpu'])/wall, 3), cpu_seconds_a_minute=round(60*(b['cpu']-a['cpu'])/wall, 3),
                received_a_second=round((got_b-got_a)/wall, 1), attitudes_a_second=round((heard_last.get(attitudes, 0)-heard_first.get(attitudes, 0))/wall, 2),
                wakeups_a_second=round((b['wakeups']-a['wakeups'])/wall, 1))

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--seconds', type=float, default=600.)
    parser.add_argument('--out', default=HERE/'gimbal.json')
    parser.add_argument('--peer', nargs=2, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.peer: return peers[args.peer[0]](**json.loads(args.peer[1]))
    load = os.getloadavg()
    rows,autopilot_percent = measure(args.seconds)
    by_name = {r['name']: r['percent_of_a_core'] for r in rows}
    for r in rows:
        if 'device' in r['name']: r['of_recv_match'],r['of_a_socket'] = (round(r['percent_of_a_core']/by_name[RUNS[i][0]], 2) for i in (0,1))
    loads = dict(load_at_start=load, load_at_end=os.getloadavg())
    write(args.out, dict(machine=machine(), seconds=args.seconds, **loads, autopilot_percent=round(autopilot_percent, 2), rows=rows))
    for r in rows: print(f'{r["name"]:36}', *(f'{k} {v}' for k,v in r.items() if k!='name'), sep='  ')
    print(loads)

if __name__=='__main__': main()
