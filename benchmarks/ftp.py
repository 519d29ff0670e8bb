"""Fetch a file by MAVLink FTP, with our client and with MAVSDK's, from our server and over the same link. See README.md."""
import argparse, asyncio, json, os, queue, statistics, subprocess, sys, tempfile, threading, time
from pathlib import Path

from trees import HERE, environment
from run import machine, write
from UAV.mavlink import CameraServer, Component, LossyLink, MAVCom, mavlink
from UAV.mavlink.camera_server import FakeCamera
from UAV.testing import free_port

# what the link is, how much is fetched, and what it could carry at best, bytes a second ------------------------------------------------

FRAME,DATA = 266,239            # bytes of a full frame, and of the data in it
LINKS = {
    'loopback': dict(size=2_000_000, link={}),
    '57,600 baud': dict(size=40_000, link=dict(baudrate=57600), best=5760*DATA/FRAME),
    '57,600 baud, 10 % lost': dict(size=40_000, link=dict(baudrate=57600, loss=.1), best=5760*.9*DATA/FRAME),
}
CLIENTS = 'UAV','MAVSDK burst','MAVSDK read'

# the same with more and more lost, in both directions; MAVSDK is slow there, and fetches a smaller file

LOSSES,TARGETS = (.05, .1, .2, .3),(.7, .6, .45, .3)
LOSSY = {
    'loopback': dict(size=3_000_000, link={}),
    '57,600 baud': dict(size=40_000, link=dict(baudrate=57600), best=5760*DATA/FRAME),
    '115,200 baud': dict(size=80_000, link=dict(baudrate=115200), best=11520*DATA/FRAME),
    'LTE, 5 Mbit/s, 60 ms': dict(size=2_000_000, link=dict(baudrate=5_000_000, latency=.06), buffer=1<<18, best=500_000*DATA/FRAME),
}
SMALL = 72_000

# the server: it makes its own link bad, in both directions -------------------------------------------------------------------------------

def serve(port, size, link, seed, buffer=LossyLink.buffer):
    "A camera server with one file; writes a line when it is there, ends with its standard input"
    way = LossyLink(f'udpout:127.0.0.1:{port}', seed=seed, **link)
    way.buffer = buffer
    com = MAVCom(way, source_system=222)
    server = com.add_component(CameraServer(mavlink.MAV_COMP_ID_CAMERA, camera=FakeCamera()))
    server.files.add('/file.bin', os.urandom(size))
    print(flush=True)
    sys.stdin.read()
    com.close()

# clients: seconds, and was it right? -----------------------------------------------------------------------------------------------------

def fetch_uav(port, size):
    async def go(com):
        camera = await com.find_camera(system=222, component=mavlink.MAV_COMP_ID_CAMERA, timeout=30)
        start = time.monotonic()
        got = await camera.files.fetch('/file.bin')
        return time.monotonic()-start,len(got)==size
    with MAVCom(f'udpin:127.0.0.1:{port}') as com: return asyncio.run(go(com))

def fetch_mavsdk(port, size, burst):
    from mavsdk import ComponentType, Configuration, Mavsdk, log_subscribe
    from mavsdk.plugins.ftp import Ftp, FtpResult
    log_subscribe(lambda level,message,file,line: True)
    ground = Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
    ground.add_any_connection_with_handle(f'udpin://127.0.0.1:{port}')
    while not (system := next((s for s in ground.get_systems() if s.get_system_id()==222), None)): time.sleep(.1)
    ftp,folder,results = Ftp(system),tempfile.TemporaryDirectory(),queue.Queue()
    ftp.set_target_compid(mavlink.MAV_COMP_ID_CAMERA)
    start = time.monotonic()
    ftp.download_async('/file.bin', folder.name, burst, lambda result,progress,_: results.put(result))
    while (result := results.get(timeout=300))==FtpResult.NEXT: pass
    took = time.monotonic()-start
    return took,result==FtpResult.SUCCESS and (Path(folder.name)/'file.bin').stat().st_size==size

def fetch(client, port, size):
    took,right = fetch_uav(port, size) if client=='UAV' else fetch_mavsdk(port, size, client=='MAVSDK burst')
    print(json.dumps([took, right]), flush=True)
    os._exit(0)                 # MAVSDK's threads do not matter here

# in turn ---------------------------------------------------------------------------------------------------------------------------------

def once(client, of, seed):
    "Seconds that one client took over a link"
    port = free_port()
    def process(*args, **how): return subprocess.Popen([sys.executable, __file__, '--part', *map(json.dumps, args)], env=environment(), stdout=subprocess.PIPE, text=True, **how)
    server = process('serve', port, of['size'], of['link'], seed, of.get('buffer', LossyLink.buffer), stdin=subprocess.PIPE)
    server.stdout.readline()
    try: took,right = json.loads(process('fetch', client, port, of['size']).communicate(timeout=400)[0])
    finally: server.communicate('')
    if not right: raise RuntimeError(f'{client} over {of}: not what the server has')
    return took

def bare(frames=8000):
    "Bytes a second of the same messages over loopback when nothing is asked, looked up or written: sent by one component, counted by another"
    port = free_port()
    with MAVCom(f'udpin:127.0.0.1:{port}') as ground, MAVCom(f'udpout:127.0.0.1:{port}', source_system=222) as vehicle:
        sender,hearer = (com.add_component(Component(n, mavlink.MAV_TYPE_CAMERA)) for com,n in ((vehicle,100),(ground,190)))
        there,count = threading.Event(),[0]
        def fits(msg):
            count[0] += 1
            if count[0]%64==0: there.set()
        with hearer.expecting(mavlink.MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL, fits):
            payload,start = bytes(range(251)),time.monotonic()
            for _ in range(0, frames, 64):
                there.clear()
                for _ in range(64): sender.send_message(sender.mav.file_transfer_protocol_encode(0, ground.source_system, 190, payload), None)
                there.wait(5)
            return count[0]*DATA/(time.monotonic()-start)

def row(name, client, seconds, best):
    "One line of the result; the share is that of what the link could carry, without anything lost twice"
    rates = sorted(LINKS[name]['size']/s for s in seconds)
    middle = statistics.median(rates)
    return dict(link=name, client=client, bytes_a_second=round(middle), low=round(rates[0]), high=round(rates[-1]), share=round(middle/best, 3), runs=len(rates))

def lossy(name, loss, client):
    "The link with this loss, and the file that this client fetches over it"
    of = LOSSY[name]
    return dict(of, size=of['size'] if client=='UAV' else min(of['size'], SMALL), link=dict(of['link'], loss=loss))

def lossy_row(name, loss, client, seconds, best):
    "One line of the table of losses: the share of what gets through, with quartiles, and its target"
    shares = sorted(lossy(name, loss, client)['size']/s/best/(1-loss) for s in seconds)
    q = statistics.quantiles(shares, n=4, method='inclusive') if len(shares)>1 else shares*3
    return dict(link=name, loss=loss, client=client, share=round(q[1], 3), quartiles=[round(q[0], 3), round(q[2], 3)],
                bytes_a_second=round(q[1]*best*(1-loss)), target=dict(zip(LOSSES, TARGETS)).get(loss), runs=len(shares))

def measure_losses(rounds, quick):
    "Rows for all links and losses, in turns; MAVSDK's bursts at 10 % beside them"
    took,losses = {},(0,.1,.3) if quick else (0,*LOSSES)
    cases = [(name,loss,'UAV') for name in LOSSY for loss in losses]+[(name,.1,'MAVSDK burst') for name in (list(LOSSY)[:1] if quick else LOSSY)]
    for n in range(rounds):
        for name,loss,client in cases: took.setdefault((name,loss,client), []).append(once(client, lossy(name, loss, client), n))
    unlimited = LOSSY['loopback']['size']/statistics.median(took['loopback',0,'UAV'])       # what it carries is what comes without losses
    return [lossy_row(*case, seconds, LOSSY[case[0]].get('best', unlimited)) for case,seconds in took.items()]

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--rounds', type=int, default=5)
    parser.add_argument('--quick', action='store_true', help='one round, fewer losses')
    parser.add_argument('--only', choices=('peers','losses'), help='one of the two tables; the other stays as it is')
    parser.add_argument('--out', default=HERE/'ftp.json')
    parser.add_argument('--part', nargs='+', help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.part:
        what,*rest = map(json.loads, [json.dumps(args.part[0].strip('"')), *args.part[1:]])
        return dict(serve=serve, fetch=fetch)[what](*rest)
    load,took,rounds = os.getloadavg(),{},1 if args.quick else args.rounds
    result = json.loads(Path(args.out).read_text()) if args.only and Path(args.out).exists() else {}
    if args.only!='losses':
        bares = []
        for n in range(rounds):
            bares.append(bare())
            for name in LINKS:
                for client in CLIENTS: took.setdefault((name,client), []).append(once(client, LINKS[name], n))
        best = {name: of.get('best', statistics.median(bares)) for name,of in LINKS.items()}
        result.update(best={n: round(b) for n,b in best.items()}, rows=[row(name, client, seconds, best[name]) for (name,client),seconds in took.items()])
    if args.only!='peers': result['losses'] = measure_losses(rounds, args.quick)
    around = dict(machine=machine(), load_at_start=load, load_at_end=os.getloadavg())
    if args.only!='losses': result.update(around)
    if args.only!='peers': result['losses_measured'] = dict(around, rounds=rounds)
    write(args.out, result)
    for r in result.get('rows', ()) if args.only!='losses' else (): print(f'{r["link"]:24}{r["client"]:16}{r["bytes_a_second"]:10} B/s {r["share"]:8.1%}   {r["low"]} – {r["high"]}')
    for r in result['losses'] if args.only!='peers' else ():
        low,high = r['quartiles']
        print(f'{r["link"]:24}{r["loss"]:5.0%} {r["client"]:16}{r["bytes_a_second"]:10} B/s {r["share"]:8.1%} ({low:.1%} – {high:.1%})', f'target {r["target"]:.0%}' if r['target'] else '')

if __name__=='__main__': main()
