"""CPU time per encoded picture: our Encoder beside ffmpeg and a GStreamer pipeline, which encode the same raw frames with the same settings. See README.md."""
import argparse, json, os, re, shutil, statistics, subprocess, sys, tempfile, threading, time
from contextlib import contextmanager
from pathlib import Path
from types import SimpleNamespace

from trees import HERE, environment
from run import compare, in_turn, machine, middle, short, table, write

RATE,KEPT,WARM = 30,20,15          # frames a second, different frames, pictures that do not count
SIZES = {'480p': (640,480), '720p': (1280,720), '1080p': (1920,1080)}
CASES = [('h264', size) for size in SIZES]+[('h265','480p')]

# the frames ---------------------------------------------------------------------------------------------------------------------------

def frames(width, height):
    "A textured ground that moves under a camera, with its noise"
    import cv2, numpy as np
    random = np.random.default_rng(0)
    ground = cv2.resize(random.integers(0, 255, (height//24,width//24,3), np.uint8), (width,height), interpolation=cv2.INTER_CUBIC)
    noise = random.normal(0, 3, (height,width,1))
    for n in range(KEPT):
        moved = np.roll(ground, (n*width//KEPT//4, n*width//KEPT), (0,1))          # a path that closes after KEPT frames, almost
        yield np.clip(moved*.7+40+np.roll(noise, n*37, 1), 0, 255).astype(np.uint8)

def write_frames(folder, width, height):
    "All in one file, for ffmpeg, and each in its own, for GStreamer and for us; all of it in memory where there is a /dev/shm"
    with open(folder/'all.raw', 'wb') as everything:
        for n,image in enumerate(frames(width, height)):
            image.tofile(folder/f'{n}.raw')
            image.tofile(everything)

# ours ---------------------------------------------------------------------------------------------------------------------------------

class Raw:
    "A source that reads the raw frames from their files, `RATE` times a second"
    def __init__(self, folder, width, height):
        import numpy as np
        self.folder,self.began = Path(folder),time.monotonic()
        self.images = [np.empty((height,width,3), np.uint8) for _ in range(3)]         # a camera has a few buffers, too

    @contextmanager
    def watching(self): yield

    def next(self, after=-1, timeout=None):
        number = max(after+1, int((time.monotonic()-self.began)*RATE))
        time.sleep(max(0, self.began+number/RATE-time.monotonic()))
        image = self.images[number%3]
        with open(self.folder/f'{number%KEPT}.raw', 'rb', buffering=0) as file: file.readinto(image)
        return SimpleNamespace(image=image, number=number, time_utc=time.time())

class Counter:
    "A sink that writes what it gets, and looks at the clock of the process"
    def __init__(self, path, count): self.file,self.count,self.numbers,self.done,self.cpu = open(path, 'wb'),count,[],threading.Event(),{}

    def put(self, unit):
        self.cpu[len(self.numbers)] = time.process_time()
        if len(self.numbers)>=self.count: return self.done.set()
        self.numbers.append(unit.number)
        self.file.write(unit.data)

def worker(folder, codec, width, height, bitrate, count):
    "Our encoder, in a process of its own: what `count` pictures cost"
    import cv2
    from UAV.video.encoder import Encoder
    cv2.setNumThreads(1)
    sink = Counter(f'{folder}/ours.bin', count)
    with Encoder(Raw(folder, width, height), codec, rate=RATE, bitrate=bitrate, hardware=False) as encoder:
        encoder.add(sink)
        if not sink.done.wait(count/RATE*3+20): raise SystemExit(f'{len(sink.numbers)} of {count} pictures; {encoder.fault}')
    sink.file.close()
    missed = sink.numbers[-1]-sink.numbers[0]+1-count
    print(json.dumps(dict(cpu=1e3*(sink.cpu[count]-sink.cpu[WARM])/(count-WARM), missed=missed, numbers=sink.numbers)))

def ours(folder, count, codec, width, height, bitrate):
    told = json.dumps(dict(folder=str(folder), codec=codec, width=width, height=height, bitrate=bitrate, count=count))
    done = subprocess.run([sys.executable, __file__, '--worker', told], env=environment(), stdout=subprocess.PIPE, text=True, check=True)
    said = json.loads(done.stdout)
    (folder/'numbers.json').write_text(json.dumps(said.pop('numbers')))
    return said

# theirs -------------------------------------------------------------------------------------------------------------------------------

def ffmpeg_line(folder, count, codec, width, height, bitrate):
    x265 = ['-x265-params','log-level=none:info=0:open-gop=0'] if codec=='h265' else []
    return ['ffmpeg','-nostdin','-y','-loglevel','error','-re','-stream_loop','-1','-f','rawvideo','-pixel_format','bgr24','-video_size',f'{width}x{height}',
            '-framerate',str(RATE),'-i',f'{folder}/all.raw','-frames:v',str(count),'-pix_fmt','yuv420p','-c:v',dict(h264='libx264', h265='libx265')[codec],
            '-preset','ultrafast','-tune','zerolatency',*x265,'-threads','1','-b:v',str(bitrate),'-maxrate',str(bitrate),'-bufsize',str(bitrate//2),
            '-g',str(RATE),'-f',dict(h264='h264', h265='hevc')[codec],f'{folder}/ffmpeg.bin']

def gst_line(folder, count, codec, width, height, bitrate):
    own = dict(h264=f'x264enc speed-preset=ultrafast tune=zerolatency threads=1 vbv-buf-capacity=500 key-int-max={RATE} bitrate={bitrate//1000}',
               h265=f'x265enc speed-preset=ultrafast tune=zerolatency key-int-max={RATE} bitrate={bitrate//1000} log-level=none')[codec]
    caps = f'video/x-raw,format=BGR,width={width},height={height},framerate={RATE}/1'
    line = f'multifilesrc location={folder}/%d.raw loop=true stop-index={KEPT-1} num-buffers={count} caps={caps} ! clocksync ! videoconvert n-threads=1 ! ' \
           f'video/x-raw,format=I420 ! {own} ! video/x-{codec},stream-format=byte-stream,alignment=au ! filesink location={folder}/gst.bin'
    return ['gst-launch-1.0','-q',*line.split()]

def used(line):
    "CPU seconds of a process, with its threads and children"
    process = subprocess.Popen(line, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    said = process.stderr.read()
    _,status,usage = os.wait4(process.pid, 0)
    process.stderr.close()
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode: raise RuntimeError(f'{line[0]}: {said.decode()[-500:]}')
    return usage.ru_utime+usage.ru_stime

def theirs(line):
    "What a picture costs: a run of `count` less one of `WARM`, so that starting does not count"
    def measure(folder, count, *case):
        few = used(line(folder, WARM, *case))
        return dict(cpu=1e3*(used(line(folder, count, *case))-few)/(count-WARM), missed=0)
    return measure

def gst_has(element): return shutil.which('gst-inspect-1.0') and subprocess.run(['gst-inspect-1.0',element], capture_output=True).returncode==0

def contenders(codec):
    "`{name: function}` of those that this machine has"
    found = {'ours': ours}
    if shutil.which('ffmpeg'): found['ffmpeg'] = theirs(ffmpeg_line)
    if gst_has(dict(h264='x264enc', h265='x265enc')[codec]): found['gst'] = theirs(gst_line)
    for name in {'ffmpeg','gst'}-set(found): print(f'{name}: not on this machine, or without an encoder for {codec}', file=sys.stderr)
    return found

# how good it is -----------------------------------------------------------------------------------------------------------------------

def quality(folder, name, codec, count):
    "Of what came out: the mean likeness of a sample to the frames that went in, dB, and the bits in a second, Mbit/s"
    import cv2, av
    import numpy as np
    path,likeness = folder/f'{name}.bin',[]
    numbers = json.loads((folder/'numbers.json').read_text()) if name=='ours' else range(count)
    with av.open(str(path), format=dict(h264='h264', h265='hevc')[codec]) as stream:
        for n,picture in enumerate(stream.decode(video=0)):
            image = picture.to_ndarray(format='bgr24')
            frame = np.fromfile(folder/f'{numbers[n]%KEPT}.raw', np.uint8).reshape(image.shape)
            if n%4==0: likeness.append(cv2.PSNR(image, frame))
    return dict(pictures=n+1, psnr=short(statistics.mean(likeness)), mbit=short(8e-6*path.stat().st_size*RATE/count))

# all of it ----------------------------------------------------------------------------------------------------------------------------

NAMES = dict(ffmpeg='ffmpeg', gst='GStreamer')

def case(codec, size, rounds, count):
    "Rows and details of one codec and size"
    from UAV.video.units import sensible_bitrate
    what = codec,*SIZES[size],sensible_bitrate(*SIZES[size], RATE, codec)
    with tempfile.TemporaryDirectory(dir='/dev/shm' if Path('/dev/shm').is_dir() else None) as folder:
        folder = Path(folder)
        write_frames(folder, *SIZES[size])
        who = contenders(codec)
        got = in_turn({name: name for name in who}, rounds, lambda name: who[name](folder, count, *what))
        good = {name: quality(folder, name, codec, count) for name in got}
    rows = [compare(f'{codec.upper()} {size}', f'{RATE} fps', NAMES[name], 'ms CPU', got['ours'], got[name], 1.1, key='cpu') for name in got if name!='ours']
    detail = {NAMES.get(name, 'UAV'): dict(cpu=middle(found)['cpu'], missed=sum(r['missed'] for r in found), **good[name]) for name,found in got.items()}
    return rows,detail

def first_line(*command):
    "What a program says of its version"
    if not shutil.which(command[0]): return 'absent'
    said = subprocess.run(command, capture_output=True, text=True).stdout
    return next(iter(re.findall(r'(?<!-)\d+\.\d+[\w.:+-]*', said)), '')

def versions():
    import av
    return dict(av=av.__version__, ffmpeg=first_line('ffmpeg','-version'), gstreamer=first_line('gst-launch-1.0','--version'))

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--quick', action='store_true', help='one short round: to see that it works, not to quote')
    parser.add_argument('--only', choices=[f'{codec}-{size}' for codec,size in CASES], help='one case; writes nothing without --out')
    parser.add_argument('--out', help='where the results go (video.json)')
    parser.add_argument('--worker', type=json.loads, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.worker: return worker(**args.worker)
    rounds,count = (1,60) if args.quick else (7,240)
    results = dict(machine=dict(machine(), **versions()), quick=args.quick, rows=[], detail={})
    for codec,size in CASES:
        if args.only not in (None, f'{codec}-{size}'): continue
        rows,results['detail'][f'{codec} {size}'] = case(codec, size, rounds, count)
        results['rows'] += rows
        for line in table(rows): print(line, flush=True)
    if args.only: print(json.dumps(results['detail'], indent=1))
    if args.out or not args.only: write(args.out or HERE/'video.json', results)

if __name__=='__main__': main()
