"""Ten minutes of everything at once: does anything grow, get stuck, or get lost? See README.md."""
from array import array
import argparse, asyncio, gc, json, statistics, sys, tempfile, threading, time

from trees import HERE
from run import Worker, free_ports, machine, write
import cv2, numpy as np, psutil
from UAV.cameras import Camera, CameraInformation, Frame, Picture
from UAV.logging import LogLevels
from UAV.mavlink import CameraClient, CameraServer, MAVCom, mavlink
from UAV.mavlink.camera_client import CAMERA_CAPTURE_STATUS, CAMERA_INFORMATION, CAMERA_SETTINGS, STORAGE_INFORMATION
cv2.setNumThreads(1)

VEHICLE,POINTS,MiB = 222,120,2**20
CAMERAS = mavlink.MAV_COMP_ID_CAMERA,mavlink.MAV_COMP_ID_CAMERA2

class Grey(Camera):
    "Every picture a little brighter, and as small as pictures get"
    information,min_interval,number,taken = CameraInformation(model='Grey', resolution_h=32, resolution_v=24),.02,0,0
    def read(self):
        self.number += 1
        return Frame(np.full((24,32,3), self.number%256, np.uint8), self.number, time.time())
    def announce(self, event):
        self.taken += isinstance(event, Picture)
        super().announce(event)
    def set_camera_zoom(self, kind, value): "A quick command"

class Operator:
    "A client on a link of its own, that keeps one camera busy and asks both for everything"
    def __init__(self, port, system, component):
        self.com = MAVCom(f'udpout:127.0.0.1:{port}', source_system=system, loglevel=LogLevels.WARNING)
        self.client = self.com.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER, loglevel=LogLevels.WARNING))
        self.client.set_target(VEHICLE, component)
        self.asked = self.noticed = self.refused = self.silent = self.formats = 0

    def note(self, ack):
        "Count a refusal"
        self.refused += not ack
        return ack

    async def shoot(self, count):
        if self.note(await self.client.image_start_capture(count=count, interval=.05)):
            self.asked += count
            self.noticed += len(await self.client.camera().wait_images(count, timeout=10))

    async def ask(self):
        "One of each question, to both cameras at once"
        questions = [self.client.camera(VEHICLE, camera).request(msg_id) for camera in CAMERAS
                     for msg_id in (CAMERA_INFORMATION, CAMERA_SETTINGS, STORAGE_INFORMATION, CAMERA_CAPTURE_STATUS)]
        self.silent += sum(m is None for m in await asyncio.gather(*questions))

    async def stream(self):
        "Have the status streamed, fast, for a while"
        status = mavlink.MAVLINK_MSG_ID_CAMERA_CAPTURE_STATUS
        self.silent += await self.client.request_message_stream(msg_id=status, interval=20_000) is None
        await asyncio.sleep(.5)
        await self.client.request_message_stream(msg_id=status, interval=-1)

    async def work(self, until):
        rounds = 0
        while time.monotonic()<until:
            if rounds%10==0:
                self.formats += 1
                self.note(await self.client.storage_format())
            await asyncio.gather(self.shoot(3), self.ask(), self.stream())
            for n in range(50): self.note(await self.client.set_camera_zoom(zoom_type=mavlink.ZOOM_TYPE_RANGE, zoom_value=n))
            rounds += 1

class Soak:
    "A server with two cameras, a vehicle that sends telemetry to it, and two operators"
    def __init__(self, seconds, folder):
        self.seconds,self.samples,port = seconds,{},free_ports()
        self.cameras = [Grey(folder=f'{folder}/{c}', quota=50) for c in CAMERAS]
        self.server = MAVCom(f'udpin:127.0.0.1:{port}', source_system=VEHICLE, loglevel=LogLevels.WARNING)
        self.servers = [self.server.add_component(CameraServer(c, camera=camera, loglevel=LogLevels.WARNING)) for c,camera in zip(CAMERAS, self.cameras)]
        self.operators = [Operator(port, system, c) for system,c in zip((255,254), CAMERAS)]
        self.sender = Worker('sender', ports=[port])
        self.sender.tell('send', port=port, seconds=seconds)
        self.process,self.start = psutil.Process(),time.monotonic()

    def sample(self):
        "A row of the record; memory is what is in use when all garbage has been collected"
        gc.collect()
        clients,names = [o.client for o in self.operators],[t.name for t in threading.enumerate()]
        cpu = self.process.cpu_times()
        now = dict(t=round(time.monotonic()-self.start, 1), rss=round(self.process.memory_info().rss/MiB, 2), blocks=sys.getallocatedblocks(),
            threads=sum(not n.startswith('capture') for n in names), capturing=sum(n.startswith('capture') for n in names), files=self.process.num_fds(),
            sent=sum(c.num_cmds_sent for c in clients), answered=sum(c.num_acks_sent for c in self.servers), lost=sum(c.num_acks_drop for c in clients),
            asked=sum(o.asked for o in self.operators), taken=sum(c.taken for c in self.cameras), noticed=sum(o.noticed for o in self.operators),
            telemetry=sum(self.server.message_cnts.get(1, {}).values()), cpu=round(cpu.user+cpu.system, 2))
        for k,v in now.items(): self.samples.setdefault(k, array('d')).append(v)      # no objects of our own among those we count

    async def run(self):
        async def record():
            while True:
                self.sample()
                await asyncio.sleep(1)
        recording = asyncio.ensure_future(record())
        await asyncio.gather(*(o.work(self.start+self.seconds) for o in self.operators))
        recording.cancel()
        for c in self.cameras: c.wait_idle(10)
        self.sample()

    def close(self):
        for o in self.operators: o.com.close()
        self.server.close()
        for c in self.cameras: c.close()

def faults(samples, operators):
    "What is not as it should be, as sentences"
    first = next(i for i,t in enumerate(samples['t']) if t>=min(60, .3*samples['t'][-1]))
    warm,end,found = {k: v[first:] for k,v in samples.items()},{k: int(v[-1]) for k,v in samples.items()},[]
    fifth = max(1, len(warm['t'])//5)
    def ends(k, f=statistics.median): return f(warm[k][:fifth]),f(warm[k][-fifth:])
    for k,what,unit in (('rss','memory','MiB'), ('blocks','what Python has allocated','objects')):
        early,late = ends(k)
        if late>1.02*early: found.append(f'{what} grew from {early:.1f} to {late:.1f} {unit}')
    if len(counts := set(warm['threads']))>1: found.append(f'between {min(counts):.0f} and {max(counts):.0f} threads')
    if max(warm['capturing'])>len(CAMERAS): found.append('more capture threads than cameras')
    early,late = ends('files', min)
    if late>early: found.append(f'open files: first {early:.0f}, then {late:.0f}')
    if end['lost'] or end['sent']>end['answered']: found.append(f'{end["lost"]} of {end["sent"]} commands lost, {end["answered"]} answered')
    if not end['asked']==end['taken']==end['noticed']: found.append(f'{end["asked"]} pictures asked for, {end["taken"]} taken, {end["noticed"]} noticed')
    for what in ('refused','silent'):
        if n := sum(getattr(o, what) for o in operators): found.append(f'{n} requests {what}')
    return found

def thinned(samples):
    "About POINTS of the rows, and the last"
    every = -(-len(samples['t'])//POINTS)
    def number(k, v): return v if k in ('t','rss','cpu') else int(v)
    return {k: [number(k, x) for x in [*v[:-1:every], v[-1]]] for k,v in samples.items()}

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--minutes', type=float, default=10.)
    parser.add_argument('--out', default=HERE/'soak.json')
    args,before = parser.parse_args(),threading.enumerate()
    with tempfile.TemporaryDirectory() as folder:
        soak = Soak(60*args.minutes, folder)
        try:
            asyncio.run(soak.run())
            telemetry_sent = soak.sender.hear(60)
        finally: soak.close(); soak.sender.close()
    found = faults(soak.samples, soak.operators)
    if left := [t.name for t in threading.enumerate() if t not in before]: found.append(f'threads left behind: {left}')
    kept = thinned(soak.samples)
    end = {k: v[-1] for k,v in kept.items()}
    totals = dict(formats=sum(o.formats for o in soak.operators), telemetry_sent=telemetry_sent, repeated=sum(c.num_cmds_rcvd for c in soak.servers)-end['sent'])
    write(args.out, dict(machine=machine(), minutes=args.minutes, faults=found, **totals, samples=kept))
    print(json.dumps(dict(end, **totals)), *(found or ['nothing grew, nothing was lost']), sep='\n')
    return 1 if found else 0

if __name__=='__main__': sys.exit(main())
