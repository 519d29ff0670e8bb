"""Ask for pictures over bad links, with this checkout and with an older one, and count what was asked, told and done. See README.md."""
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import SimpleNamespace as ns
import argparse, asyncio, json, statistics, subprocess, sys, threading, time

from trees import HERE, environment, ours
from run import machine, trees, write
from soak import Grey
from UAV.logging import LogLevels
from UAV.mavlink import CameraClient, CameraServer, Component, MAVCom, mavlink

LossyLink,QUIET = ours('LossyLink'),dict(loglevel=LogLevels.CRITICAL)

# what the weather is, each way; what is asked, how often, how long we wait in between; and on how many days -------------------------

PER_SECOND = 5760               # bytes at 57,600 baud
LOSSY = dict(loss=.2, duplicate=.1, reorder=.1, latency=.01, jitter=.04)         # 30 ± 20 ms
SCENARIOS = {
    'no loss': dict(asks=200),
    'no loss, a camera that does not tell': dict(asks=200, tells=False),
    'no loss, a new client for each': dict(asks=20, restart=True),
    '20 % lost, 10 % doubled, 10 % late, 30 ± 20 ms': dict(asks=200, **LOSSY),
    'the same, a camera that does not tell': dict(asks=200, tells=False, **LOSSY),
    'jitter of 0.2 s, 5 % lost': dict(asks=100, days=2, loss=.05, jitter=.2),
    '40 % lost, 300 ms': dict(asks=40, days=5, loss=.4, latency=.3),
    '1 s there and back, 20 % lost': dict(asks=50, days=4, loss=.2, latency=.5),
    '2 s there and back, 20 % lost': dict(asks=40, days=5, loss=.2, latency=1.),
    '57,600 baud, half full': dict(asks=200, baudrate=57600, telemetry=.5),
    '57,600 baud, half full, does not tell': dict(asks=200, tells=False, baudrate=57600, telemetry=.5),
    'three outages of 3 s': dict(asks=80, pace=.3, loss=.05, latency=.02, outages=[(3,6),(10,13),(18,21)]),
    'two outages of 8 s': dict(asks=100, pace=.3, loss=.05, latency=.02, outages=[(3,11),(19,27)]),
    'bursts of 3, 2 s there and back, 20 % lost': dict(asks=10, days=4, loss=.2, latency=1., count=3),
    'zoom steps, 20 % lost, 10 % doubled, 10 % late': dict(asks=200, zoom=True, **LOSSY),
    'zoom steps, 1 s there and back, 20 % lost': dict(asks=50, days=4, zoom=True, loss=.2, latency=.5),
}

def half(way):
    "What each of two radios in a row has to do, so that both together make this weather"
    rare = {k: 1-(1-way.get(k, 0))**.5 for k in ('loss','duplicate','reorder')}
    return dict(rare, **{k: way.get(k, 0)/2 for k in ('latency','jitter')})

# who asked for what -----------------------------------------------------------------------------------------------------------------

class Journal:
    "Which ask each frame of the client belongs to, and what was done for each ask"
    def __init__(self):
        self.ask,self.asked_by = -1,{}        # the one under way; {sequence number of a frame: ask}
        self.frames,self.done = Counter(),Counter()
        self.order = []                       # the ask that each picture was taken for

    def sent(self, frame):
        self.asked_by[frame[4]] = self.ask
        self.frames[int.from_bytes(frame[7:10], 'little')] += 1

    def did(self, n, caller):
        ask = self.asked_by[answered_now(caller).get_seq()]
        self.done[ask] += n
        self.order += [ask]*n

def answered_now(frame):
    "The command that is being answered, found among the callers: no checkout need give it to the camera"
    while frame:
        msg = frame.f_locals.get('msg')
        if hasattr(msg, 'command') and hasattr(msg, 'get_seq'): return msg
        frame = frame.f_back
    raise LookupError('not called for a command')

class Radio(LossyLink):
    "The client's end"
    def write(self, data, peer=None):
        self.journal.sent(data)
        super().write(data, peer)

class Counted(Grey):
    "A camera that notes for which ask it does something; it `tells` which picture it will be, or not, as most cameras"
    def __init__(self, journal, tells=True):
        super().__init__()
        self.journal,self.tells = journal,tells

    def image_start_capture(self, interval=0., count=1):
        index = super().image_start_capture(interval, count)
        self.journal.did(int(count), sys._getframe(1))
        return index if self.tells else None

    def set_camera_zoom(self, kind, value): self.journal.did(1, sys._getframe(1))

# one day of a scenario, in a process of its own -------------------------------------------------------------------------------------

def play(name, seed, quick=False):
    "What came of it, as a dict; `quick`: a tenth of the asks"
    way,journal = dict(SCENARIOS[name]),Journal()
    if quick: way['asks'] = max(3, way['asks']//10)
    radio = Radio('udpin:127.0.0.1:0', seed=f'{seed} {name} ground', **half(way))
    radio.journal,radio.baudrate = journal,way.get('baudrate')
    far = LossyLink(f'udpout:127.0.0.1:{radio.port}', seed=f'{seed} {name} far', **half(way))
    camera = Counted(journal, way.get('tells', True))
    with MAVCom(radio, source_system=255, **QUIET) as ground, MAVCom(far, source_system=1, **QUIET) as drone, camera:
        drone.add_component(CameraServer(camera=camera, **QUIET))
        if 'telemetry' in way: chatter(drone.add_component(Component(1, mavlink.MAV_TYPE_QUADROTOR, **QUIET)), way['telemetry']*PER_SECOND)
        begun = time.monotonic()
        asks = asyncio.run(ask_all(way, ground, (radio,far), journal))
        seconds = time.monotonic()-begun
        camera.wait_idle(10)
    return tally(asks, journal, way.get('count', 1), seconds)

async def ask_all(way, ground, radios, journal):
    "One ask after the other: what was told, and how long it took"
    client,asks = new_client(ground),[]
    how = zoom_in if 'zoom' in way else capture
    if not await client.wait_heartbeat(target_system=1, timeout=60): raise SystemExit('the drone does not beat')
    for r in radios: r.outages = [(time.monotonic()-r.opened+start, time.monotonic()-r.opened+end) for start,end in way.get('outages', ())]
    for journal.ask in range(way['asks']):
        asks.append(await timed(how, client, way.get('count', 1)))
        await asyncio.sleep(way.get('pace', 0.))
        if 'restart' in way: client = new_client(ground, client)
    await asyncio.sleep(2*way.get('latency', 0.)+way.get('jitter', 0.)+1.)        # what is under way may still do harm
    return asks

def new_client(com, old=None):
    "A client on `com`, in the place of an `old` one"
    if old: old.close()
    client = com.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER, **QUIET))
    client.set_target(1, mavlink.MAV_COMP_ID_CAMERA)
    return client

def chatter(component, rate):
    "Send `rate` bytes of telemetry a second, for as long as the link is open"
    def send():
        while True:
            try: component.send_message(component.mav.attitude_encode(0x01010101, 1., 1., 1., 1., 1., 1.))      # 40 bytes
            except Exception: return                    # the link is closed
            time.sleep(40/rate)
    threading.Thread(target=send, daemon=True).start()

# two ways to ask: each gives how many it was told are done, the notices it was given, and what was raised ---------------------------

async def capture(client, count):
    "The pictures of this request, as they come: what was given is promised"
    pictures = []
    try:
        async for picture in client.camera().capture(count, interval=.2*(count>1)): pictures.append(picture)
    except Exception as e: return len(pictures),pictures,type(e).__name__
    return len(pictures),pictures,''

async def zoom_in(client, count):
    "A step, which has no number, and looks like every other"
    return int(bool(await client.set_camera_zoom(zoom_type=mavlink.ZOOM_TYPE_STEP, zoom_value=1))),[],''

async def timed(ask, client, count):
    start = time.monotonic()
    told,pictures,error = await ask(client, count)
    return ns(told=told, images=[p.image_index for p in pictures], error=error, seconds=time.monotonic()-start)

def tally(asks, journal, count, seconds):
    "What came of a day"
    done,order = journal.done,journal.order
    return dict(asked=len(asks)*count, told=sum(a.told for a in asks), done=sum(done.values()),
                twice=sum(max(0, done[k]-count) for k in range(len(asks))),                             # done more often than asked
                missing=sum(max(0, a.told-done[k]) for k,a in enumerate(asks)),                         # told, and not done
                untold=sum(max(0, min(count, done[k])-a.told) for k,a in enumerate(asks)),              # done, and not told
                notices=sum(len(a.images) for a in asks),
                others=sum(i>=len(order) or order[i]!=k for k,a in enumerate(asks) for i in a.images),  # the notice of another ask's picture
                seconds=round(seconds, 1), commands=journal.frames[mavlink.MAVLINK_MSG_ID_COMMAND_LONG],
                frames=sum(n for i,n in journal.frames.items() if i!=mavlink.MAVLINK_MSG_ID_HEARTBEAT),
                errors=dict(Counter(a.error for a in asks if a.error)), times=[round(a.seconds, 3) for a in asks])

def together(days):
    "The days of a scenario as one row: sums, and how long one ask took"
    times = sorted(t for d in days for t in d['times'])
    errors = sum((Counter(d['errors']) for d in days), Counter())
    sums = {k: round(sum(d[k] for d in days), 1) for k in days[0] if k not in ('errors','times')}
    spread = dict(median=round(statistics.median(times), 3), p95=round(times[int(.95*len(times))], 3), longest=round(times[-1], 1))
    return dict(sums, **spread, **(dict(errors=errors) if errors else {}))

# all of them ------------------------------------------------------------------------------------------------------------------------

def start(name, tree, seed, quick):
    "Play a day in a process of its own"
    ran = subprocess.run([sys.executable, __file__, '--play', name, '--seed', seed, *['--quick']*quick], env=environment(tree), capture_output=True, text=True, timeout=3600)
    if ran.returncode: raise SystemExit(f'{name}, {tree or "now"}: {ran.stderr[-2000:]}')
    return json.loads(ran.stdout.splitlines()[-1])

COLUMNS = 'asked','told','done','twice','missing','untold','notices','others','median','p95','seconds','commands','frames'

def table(rows):
    yield f'{"":60}'+''.join(f'{c:>9}' for c in COLUMNS)
    for r in rows: yield f'{r["name"]+", "+r["code"]:60}'+''.join(f'{r[c]:9}' for c in COLUMNS)+f'  {r.get("errors", "")}'

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--before', type=Path, help='an older checkout, measured as well')
    parser.add_argument('--quick', action='store_true', help='a tenth of it: to see that it works, not to quote')
    parser.add_argument('--seed', default='issue 7', help='of the dice: another one is another day')
    parser.add_argument('--parallel', type=int, default=16, help='processes at a time; they mostly wait')
    parser.add_argument('--only', help='scenarios with this in their name; writes nothing without --out')
    parser.add_argument('--out', help='where the results go (bad_links.json)')
    parser.add_argument('--play', choices=SCENARIOS, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.play: return print(json.dumps(play(args.play, args.seed, args.quick)))
    names,rows = [n for n in SCENARIOS if (args.only or '') in n],[]
    with ThreadPoolExecutor(args.parallel) as pool:
        days = {(name,label): [pool.submit(start, name, tree, f'{args.seed} {day}', args.quick) for day in range(1 if args.quick else SCENARIOS[name].get('days', 1))]
                for name in names for label,tree in trees(args.before).items()}
        for (name,label),futures in days.items():
            rows.append(dict(name=name, code=label.strip() or 'now', **together([f.result() for f in futures])))
            print(*list(table(rows[-1:]))[len(rows)>1:], sep='\n', flush=True)
    if args.out or not args.only: write(args.out or HERE/'bad_links.json', dict(machine=machine(args.before), quick=args.quick, seed=args.seed, rows=rows))

if __name__=='__main__': main()
