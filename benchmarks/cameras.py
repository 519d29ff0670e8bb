"""Six cameras in one server for ten minutes, one unplugged every minute: is anything lost? And what does each cost? See README.md."""
import argparse, asyncio, json, statistics, subprocess, sys, tempfile, threading, time
from pathlib import Path

from trees import HERE, environment
from run import free_ports, machine, write
import psutil

NAMES = 'nose','tail','left','right','down','heat'
RATE,SIZE,MiB = 10,(320,240),2**20
APART,FILM,AWAY = 2.,20.,15.    # s: between two pictures of a camera; of a recording; that a camera stays unplugged

# the server ------------------------------------------------------------------------------------------------------------------------------

def prepared_camera():
    "The class of a camera whose frames were drawn before: it costs what a server does with frames, and not how ours are simulated"
    from UAV.cameras import Camera, CameraError, CameraInformation, Frame, SimCamera
    with SimCamera(*SIZE) as drawn:
        images = []
        for n in range(15):
            drawn.yaw = 2*n
            images.append(drawn.read().image)
    class Prepared(Camera):
        information = CameraInformation(model='Prepared', resolution_h=SIZE[0], resolution_v=SIZE[1])
        frame_rate,number,plugged = RATE,0,True
        def read(self):
            if not self.plugged: raise CameraError('unplugged')
            self.number += 1
            return Frame(images[self.number%len(images)], self.number, time.time())
    return Prepared

def payload(folder, count, port):
    "Open this many cameras as `uav-camera-server --config` does"
    from UAV.cli.serve import _described, main
    from UAV.cli.payload import Payload
    from UAV.utils.devices import register_device
    from unittest.mock import patch
    kind = prepared_camera()
    register_device('prepared', lambda url, **storage: kind(**storage))
    lines = [f'connection = "udpout:127.0.0.1:{port}"', 'rtsp = 0', 'host = "127.0.0.1"', f'folder = "{folder}"', f'rate = {RATE}']
    lines += [line for name in NAMES[:count] for line in (f'[cameras.{name}]', f'device = "prepared://{name}"')]
    file = Path(folder, 'cameras.toml')
    file.write_text('\n'.join(lines))
    with patch('UAV.cli.serve._serve', lambda typed: typed): typed = main(['--config', str(file)])
    return Payload(_described(typed))

# the ground ------------------------------------------------------------------------------------------------------------------------------

class Viewer:
    "Plays one RTSP path as a player does, and notes when each picture came"
    def __init__(self, uri):
        self.uri,self.came,self.opened,self.over = uri,[],0,False
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def run(self):
        import av
        while not self.over:
            try:
                with av.open(self.uri, timeout=10., options=dict(rtsp_transport='tcp')) as video:
                    self.opened += 1
                    for packet in video.demux(video=0):
                        if self.over: return
                        if packet.size: self.came.append(time.time())
            except Exception: time.sleep(.5)

async def operate(camera, until, counts):
    "Take a picture every two seconds, and record most of the time"
    async def shoot():
        while time.time()<until:
            counts['asked'] += 1
            try:
                async for picture in camera.capture():
                    if picture.capture_result: counts['taken'].append(picture.image_index)
                    else: counts['failed'].append([time.time(), f'picture {picture.image_index} was reported as failed'])
            except Exception as e: counts['failed'].append([time.time(), str(e)])
            await asyncio.sleep(APART)
    async def film():
        while time.time()<until-FILM:
            began = time.time()
            try: (await camera.client.video_start_capture(camera.system, camera.component)).check()
            except Exception as e:
                counts['refused'].append(str(e))
                await asyncio.sleep(APART)
                continue
            await asyncio.sleep(FILM)
            (await camera.client.video_stop_capture(camera.system, camera.component)).check()
            counts['films'].append((began, time.time()))
    await asyncio.gather(shoot(), film())

async def ground(port, uris, seconds):
    "Be six operators and six players; print what was seen as JSON"
    from UAV import MAVCom
    with MAVCom(f'udpin:127.0.0.1:{port}', source_system=255) as com:
        cameras = sorted(await com.find_cameras(count=len(uris), timeout=60), key=lambda camera: camera.component)
        viewers = [Viewer(uri) for uri in uris]
        counts = [dict(asked=0, taken=[], failed=[], films=[], refused=[]) for _ in cameras]
        print('ready', flush=True)
        until = time.time()+seconds
        await asyncio.gather(*(operate(camera, until, count) for camera,count in zip(cameras, counts)))
        for viewer in viewers: viewer.over = True
        for viewer in viewers: viewer.thread.join(15)
    print(json.dumps([dict(count, came=viewer.came, opened=viewer.opened) for count,viewer in zip(counts, viewers)]), flush=True)

class Ground:
    "A ground station in a process of its own"
    def __init__(self, port, uris, seconds):
        words = [sys.executable, __file__, '--ground', str(port), str(seconds), *uris]
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment())
        assert self.process.stdout.readline()=='ready\n'
    def result(self): return json.loads(self.process.communicate(timeout=300)[0])

# the soak --------------------------------------------------------------------------------------------------------------------------------

def uris_of(served): return [slot.device.streams[0].uri() for slot in served.cameras.values()]

def sample(process, began):
    cpu = process.cpu_times()
    return dict(t=round(time.monotonic()-began, 1), rss=round(process.memory_info().rss/MiB, 1), cpu=round(cpu.user+cpu.system, 2),
                threads=threading.active_count(), files=process.num_fds())

def soak(minutes, folder):
    "Serve, unplug one camera every minute, and return what happened"
    process,port,began = psutil.Process(),free_ports(),time.monotonic()
    before = threading.enumerate()
    with payload(folder, 1, free_ports()): pass             # what is made once stays
    files,served = process.num_fds(),payload(folder, len(NAMES), port)
    samples,away = [],[]
    try:
        devices = {name: slot.device for name,slot in served.cameras.items()}
        there = Ground(port, uris_of(served), 60*minutes)
        end,n = time.monotonic()+60*minutes,0
        next_one = time.monotonic()+30
        while time.monotonic()<end:
            samples.append(sample(process, began))
            if time.monotonic()>=next_one:
                name = NAMES[n%len(NAMES)]
                devices[name].plugged,n,next_one = False,n+1,next_one+60
                away.append([name, time.time(), None])
            for one in away:
                if one[2] is None and time.time()-one[1]>=AWAY: devices[one[0]].plugged,one[2] = True,time.time()
            time.sleep(1)
        for one in away: devices[one[0]].plugged,one[2] = True,one[2] or time.time()
        seen = there.result()
        faults = {name: device.fault for name,device in devices.items() if device.fault}
        for device in devices.values(): device.wait_idle(30)
        shots = {name: [(p.index, p.ok, str(device.storage.folder/p.file) if p.file else None) for p in device.pictures] for name,device in devices.items()}
        films = {name: [str(file) for storage in device.storages for file in storage.recordings] for name,device in devices.items()}
    finally: served.close()
    left = [thread.name for thread in threading.enumerate() if thread not in before and thread.name!='timers']
    return dict(samples=samples, away=away, seen=seen, shots=shots, films=films, faults=faults, threads_left=left, files_left=process.num_fds()-files)

def is_jpeg(file):
    data = Path(file).read_bytes()
    return data[:2]==b'\xff\xd8' and data[-2:]==b'\xff\xd9'

def film_seconds(file):
    "Return the length of a recording whose pictures can all be decoded"
    import av
    with av.open(file) as video:
        times = [picture.time for picture in video.decode(video=0)]
    return times[-1]-times[0]+1/RATE if times else 0.

def rates(came, begins, ends): return sum(begins<=t<ends for t in came)/(ends-begins)

def verdict(found):
    "Return numbers, and what isn't as it should be"
    rows,wrong = [],list(f'{name} is still faulty: {why}' for name,why in found['faults'].items())
    for name,seen in zip(NAMES, found['seen']):
        shots = {index: (ok,file) for index,ok,file in found['shots'][name]}
        lost = [index for index in seen['taken'] if not (index in shots and shots[index][0] and is_jpeg(shots[index][1]))]
        seconds = [film_seconds(file) for file in found['films'][name]]
        away = [(a,b) for who,a,b in found['away'] if who==name]
        other = [why for when,why in seen['failed'] if not any(a<=when<=b+3 for a,b in away)]
        wanted = sum(b-a for a,b in seen['films'])
        missing = sum(max(0, min(b, away_b)-max(a, away_a)) for a,b in seen['films'] for away_a,away_b in away)
        quiet = [(a,b) for who,a,b in found['away'] if who!=name]                   # others are unplugged
        steady = [rates(seen['came'], a, b) for a,b in quiet]
        usual = [rates(seen['came'], a-AWAY, a) for a,b in quiet]
        rows.append(dict(camera=name, asked=seen['asked'], taken=len(seen['taken']), failed_unplugged=len(seen['failed'])-len(other), failed=len(other),
            lost=len(lost), recordings=len(seconds), recorded_s=round(sum(seconds)), filmed_s=round(wanted), unplugged_s=round(missing),
            refused=len(seen['refused']), players=seen['opened'], fps_before=round(statistics.median(usual), 2) if usual else None,
            fps_others_unplugged=round(statistics.median(steady), 2) if steady else None, fps_lowest=round(min(steady), 2) if steady else None))
        if lost: wrong.append(f'{name}: pictures {lost} were acknowledged and are not there')
        if seen['asked']!=len(seen['taken'])+len(seen['failed']): wrong.append(f'{name}: {seen["asked"]} pictures asked for, {len(seen["taken"])} taken, {len(seen["failed"])} failed')
        if other: wrong.append(f'{name}: {other[:3]}')
        if not all(seconds): wrong.append(f'{name}: an empty recording')
        if sum(seconds)<.95*(wanted-missing)-len(seen['films']): wrong.append(f'{name}: {sum(seconds):.0f} s recorded of {wanted:.0f} s, {missing:.0f} s of them unplugged')
        if steady and usual and statistics.median(steady)<.95*statistics.median(usual): wrong.append(f'{name}: {statistics.median(steady):.1f} frames a second while others are unplugged, {statistics.median(usual):.1f} before')
    if found['threads_left']: wrong.append(f'threads left: {found["threads_left"]}')
    if found['files_left']>0: wrong.append(f'{found["files_left"]} file handles left')
    return rows,wrong

# the cost --------------------------------------------------------------------------------------------------------------------------------

def cost(count, folder, seconds):
    "Serve this many cameras: idle, watched, and recorded; print a row of each"
    process,port = psutil.Process(),free_ports()
    with payload(folder, count, port) as served:
        devices = [slot.device for slot in served.cameras.values()]
        def measure(what):
            time.sleep(2)
            a,began = process.cpu_times(),time.monotonic()
            time.sleep(seconds)
            b = process.cpu_times()
            used = (b.user+b.system-a.user-a.system)/(time.monotonic()-began)
            return dict(cameras=count, what=what, cpu_percent=max(round(100*used, 1), 0.), rss=round(process.memory_info().rss/MiB, 1), threads=threading.active_count(), files=process.num_fds())
        rows = [measure('idle')]
        words = ['ffmpeg','-v','quiet','-rtsp_transport','tcp']
        players = [subprocess.Popen([*words, '-i', uri, '-c', 'copy', '-f', 'null', '-'], stdin=subprocess.DEVNULL) for uri in uris_of(served)]
        rows.append(measure('one viewer each'))
        for device in devices: device.video_start_capture()
        rows.append(measure('viewer and recording each'))
        for device in devices: device.video_stop_capture()
        for player in players: player.kill(); player.wait()
    print(json.dumps(rows))

def costs(counts, seconds):
    rows = []
    for count in counts:
        with tempfile.TemporaryDirectory() as folder:
            words = [sys.executable, __file__, '--cost', str(count), folder, str(seconds)]
            rows += json.loads(subprocess.run(words, stdout=subprocess.PIPE, text=True, env=environment(), timeout=300, check=True).stdout.splitlines()[-1])
    return rows

def per_camera(rows):
    "What each camera after the first one adds"
    def of(count, what): return next(row for row in rows if (row['cameras'],row['what'])==(count,what))
    most,least = max(row['cameras'] for row in rows),min(row['cameras'] for row in rows)
    if most==least: return []
    return [dict(what=what, **{key: max(round((of(most, what)[key]-of(least, what)[key])/(most-least), 1), 0.) for key in ('cpu_percent','rss','threads','files')})
            for what in dict.fromkeys(row['what'] for row in rows)]

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--minutes', type=float, default=10.)
    parser.add_argument('--seconds', type=float, default=10., help='of each measurement of the cost')
    parser.add_argument('--only', choices=('soak','cost'))
    parser.add_argument('--out', default=HERE/'cameras.json')
    parser.add_argument('--ground', nargs='+', help=argparse.SUPPRESS)
    parser.add_argument('--cost', nargs=3, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.ground: return asyncio.run(ground(int(args.ground[0]), args.ground[2:], float(args.ground[1])))
    if args.cost: return cost(int(args.cost[0]), args.cost[1], float(args.cost[2]))
    old = json.loads(Path(args.out).read_text()) if Path(args.out).exists() else {}
    new,wrong = dict(old, machine=machine()),[]
    if args.only!='cost':
        with tempfile.TemporaryDirectory() as folder:
            found = soak(args.minutes, folder)
            rows,wrong = verdict(found)
        samples = found['samples']
        first,last = samples[0],samples[-1]
        warm = next(s for s in samples if s['t']>=min(120, .4*last['t']))
        if last['rss']>1.05*warm['rss']: wrong.append(f'memory grew from {warm["rss"]} MiB after {warm["t"]:.0f} s to {last["rss"]} MiB')
        cpu = 100*(last['cpu']-first['cpu'])/(last['t']-first['t'])
        usage = dict(cpu_percent=round(cpu, 1), rss_warm=warm['rss'], rss_end=last['rss'], threads=max(s['threads'] for s in samples), files=max(s['files'] for s in samples))
        new |= dict(minutes=args.minutes, faults=wrong, unplugged=len(found['away']), server=usage, threads_left=found['threads_left'], files_left=found['files_left'], soak=rows)
        for row in rows: print(row)
        print(usage, *(wrong or ['nothing was lost']), sep='\n')
    if args.only!='soak':
        rows = costs((1,2,4,6), args.seconds)
        new |= dict(cost=rows, each_further_camera=per_camera(rows))
        for row in (*rows, *per_camera(rows)): print(row)
    write(args.out, new)
    return 1 if wrong else 0

if __name__=='__main__': sys.exit(main())
