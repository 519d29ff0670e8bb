"""The panel's picture over a thin link that loses packets: WebRTC beside the JPEG way, in Chromium; how late, how many, how many bytes. See README.md.
As root on Linux: the aircraft (camera and panel) is in a network of its own, and `tc` and `iptables` make the link."""
import argparse, json, os, select, statistics, subprocess, sys, time
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from types import SimpleNamespace

import panel as marked
from panel import PROBE, SIZE, chromium_version, painted_camera, read_bits, tell
from run import in_turn, machine, middle, short, write
from trees import HERE, environment

RATE,BITRATE = 15,700_000           # pictures and bits in a second
LINK,QUEUE,LOSSES = '1mbit',500,(0,2,5)         # of each direction: its rate; ms that packets may wait for it; % of them lost
AIR,GROUND = '10.77.31','10.77.32'
WAYS = {'WebRTC': '', 'JPEG': '&jpeg'}

turns = count()

# the link -----------------------------------------------------------------------------------------------------------------------------

def run(line): subprocess.run(line.split(), check=True, stdout=subprocess.DEVNULL)

@contextmanager
def link(loss):
    "A network for the aircraft, and a router between it and the browser: it drops packets (iptables), and lets the others through slowly (tbf)"
    n = f'{os.getpid()%10_000}{next(turns)}'
    air,router,ground,sky,up,down = f'uav{n}a',f'uav{n}r',f'uvg{n}',f'uvr{n}',f'uvu{n}',f'uvd{n}'       # two networks, and the ends of two cables
    for space in (air, router): run(f'ip netns add {space}')
    def inside(space, line): run(f'ip netns exec {space} {line}')
    try:
        run(f'ip link add {ground} type veth peer name {down} netns {router}')
        inside(air, f'ip link add {sky} type veth peer name {up} netns {router}')
        run(f'ip address add {GROUND}.1/24 dev {ground}')
        run(f'ip link set {ground} up')
        for space,name,place in ((air, sky, f'{AIR}.1'), (router, up, f'{AIR}.2'), (router, down, f'{GROUND}.2')):
            inside(space, f'ip address add {place}/24 dev {name}')
            for one in ('lo', name): inside(space, f'ip link set {one} up')
        run(f'ip route add {AIR}.0/24 via {GROUND}.2')
        inside(air, f'ip route add {GROUND}.0/24 via {AIR}.2')
        inside(router, 'sysctl -q net.ipv4.ip_forward=1')
        if loss: inside(router, f'iptables -A FORWARD -m statistic --mode random --probability {loss/100} -j DROP')
        for name in (up, down): inside(router, f'tc qdisc add dev {name} root tbf rate {LINK} burst 4kb latency {QUEUE}ms')
        yield SimpleNamespace(space=air, received=lambda: int(Path(f'/sys/class/net/{ground}/statistics/rx_bytes').read_text()))
    finally:
        subprocess.run(['ip','link','delete',ground])           # a network is deleted some time later
        for space in (air, router): run(f'ip netns delete {space}')

# the aircraft -------------------------------------------------------------------------------------------------------------------------

def aircraft():
    "A camera server and the panel, which gets its stream within one computer"
    from UAV.mavlink import CameraClient, CameraServer, MAVCom
    from UAV.manager import Gui
    with painted_camera() as camera, MAVCom('virtual:air', source_system=1) as com, MAVCom('virtual:air', source_system=255) as ground:
        camera.add_stream(port=0, host='127.0.0.1', rate=RATE, bitrate=BITRATE)
        com.add_component(CameraServer(camera=camera))
        with Gui(ground.add_component(CameraClient(190))) as gui:
            tell(page=gui.serve(host=f'{AIR}.1').url)
            sys.stdin.read()

@contextmanager
def flying(space):
    line = ['ip','netns','exec',space,sys.executable,__file__,'--worker']
    worker = subprocess.Popen(line, env=dict(environment(), PYTHONPATH=environment()['UAV_TREE']), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        if not select.select([worker.stdout], [], [], 60)[0]: raise RuntimeError('the aircraft does not start')
        yield json.loads(worker.stdout.readline())['page']
    finally:
        worker.kill()
        worker.wait()
        for f in (worker.stdin, worker.stdout): f.close()

# the ground ---------------------------------------------------------------------------------------------------------------------------

SHOWN = "[...document.querySelectorAll('.card[data-main] .picture :is(video:not(.trying), img)')].find(one => !one.hidden && (one.videoWidth || one.naturalWidth))"
LOOK = PROBE.replace(f'[...document.images].find(image => image.naturalWidth == {SIZE[0]})', SHOWN) \
    .replace('image.naturalWidth, image.naturalWidth*3/32', '(image.videoWidth || image.naturalWidth), (image.videoWidth || image.naturalWidth)*3/32')
assert LOOK.count('videoWidth')==3, 'the probe of panel.py has changed'

def judge(good, seconds, size):
    "How late pictures were (ms), how many came a second, the longest pause (ms), and kB in a second"
    late = sorted(((at-then)%marked.BITS)/1000 for _,then,at in good)
    pauses = [(b-a)/1000 for (*_,a),(*_,b) in zip(good, good[1:])]
    return dict(p50=short(statistics.median(late)), p95=short(late[int(.95*(len(late)-1)+.5)]), fps=short(len({n for n,*_ in good})/seconds),
                pause=short(max(pauses)), kB=short(size/seconds/1000))

def measure(contender, seconds):
    from tests.browser import Browser
    way,loss = contender
    with link(loss) as wire, flying(wire.space) as page_url, Browser() as browser:
        page = browser.open(page_url+WAYS[way])
        page.js(LOOK)
        page.until(f"probe.seen.length > 10 && ({SHOWN})?.tagName == '{'IMG' if WAYS[way] else 'VIDEO'}'", timeout=60)
        time.sleep(8)                                           # until the browser has measured the link
        page.js('probe.seen.length = 0')
        before = wire.received()
        time.sleep(seconds)
        size = wire.received()-before
        found = page.js('probe.on = false; return probe.seen')
        still = page.js(f'return ({SHOWN})?.tagName')
    if still!=('IMG' if WAYS[way] else 'VIDEO'): print(f'{way} {loss} %: at the end there is {still}', file=sys.stderr)
    read = [(read_bits(text),int(at*1000)%marked.BITS) for text,at in found]
    good = [(*mark,at) for mark,at in read if mark]
    if len(good)<3: raise RuntimeError(f'{way} {loss} %: {len(good)} pictures')
    return dict(judge(good, seconds, size), unreadable=len(read)-len(good))

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--quick', action='store_true', help='one short round: to see that it works, not to quote')
    parser.add_argument('--rounds', type=int, default=3)
    parser.add_argument('--seconds', type=float, default=20.)
    parser.add_argument('--out', help='where the results go (webrtc.json)')
    parser.add_argument('--worker', action='store_true', help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.worker: return aircraft()
    rounds,seconds = (1,5.) if args.quick else (args.rounds,args.seconds)
    who = {f'{way}, {loss} %': (way,loss) for loss in LOSSES for way in WAYS}
    load = [os.getloadavg()[0]]
    got = in_turn(who, rounds, lambda c: measure(c, seconds))
    load.append(os.getloadavg()[0])
    detail = {name: middle(found) for name,found in got.items()}
    for name,r in detail.items(): print(f'{name:14}', *(f'{k} {v:g}' for k,v in r.items()), sep='  ')
    write(args.out or HERE/'webrtc.json', dict(machine=dict(machine(), chromium=chromium_version()), quick=args.quick, size=SIZE, rate=RATE, bitrate=BITRATE,
        link=LINK, queue=QUEUE, seconds=seconds, rounds=rounds, load=load, detail=detail, got=got))

if __name__=='__main__': main()
