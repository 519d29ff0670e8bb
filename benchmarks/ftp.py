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

# the server: it makes its own link bad, in both directions -------------------------------------------------------------------------------

def serve(port, size, link, seed):
    "A camera server with one file; writes a line when it is there, ends with its standard input"
    com = MAVCom(LossyLink(f'udpout:127.0.0.1:{port}', seed=seed, **link), source_system=222)
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

def once(client, name, seed):
    "Seconds that one client took"
    of,port = LINKS[name],free_port()
    def process(*args, **how): return subprocess.Popen([sys.executable, __file__, '--part', *map(json.dumps, args)], env=environment(), stdout=subprocess.PIPE, text=True, **how)
    server = process('serve', port, of['size'], of['link'], seed, stdin=subprocess.PIPE)
    server.stdout.readline()
    try: took,right = json.loads(process('fetch', client, port, of['size']).communicate(timeout=400)[0])
    finally: server.communicate('')
    if not right: raise RuntimeError(f'{client} over {name}: not what the server has')
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

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--rounds', type=int, default=5)
    parser.add_argument('--quick', action='store_true', help='one round')
    parser.add_argument('--out', default=HERE/'ftp.json')
    parser.add_argument('--part', nargs='+', help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.part:
        what,*rest = map(json.loads, [json.dumps(args.part[0].strip('"')), *args.part[1:]])
        return dict(serve=serve, fetch=fetch)[what](*rest)
    load,took,bares = os.getloadavg(),{},[]
    for n in range(1 if args.quick else args.rounds):
        bares.append(bare())
        for name in LINKS:
            for client in CLIENTS: took.setdefault((name,client), []).append(once(client, name, n))
    best = {name: of.get('best', statistics.median(bares)) for name,of in LINKS.items()}
    rows = [row(name, client, seconds, best[name]) for (name,client),seconds in took.items()]
    write(args.out, dict(machine=machine(), load_at_start=load, load_at_end=os.getloadavg(), best={n: round(b) for n,b in best.items()}, rows=rows))
    for r in rows: print(f'{r["link"]:24}{r["client"]:16}{r["bytes_a_second"]:10} B/s {r["share"]:8.1%}   {r["low"]} – {r["high"]}')

if __name__=='__main__': main()
