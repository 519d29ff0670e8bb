"""Every way out of our encoder, watched by players that are not ours: what arrives, and how late; and our RTSP, RTP and MPEG-TS beside gst-rtsp-server and ffmpeg. See README.md."""
import argparse, json, math, os, select, shutil, statistics, subprocess, sys, tempfile, threading, time
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from types import SimpleNamespace

from trees import HERE, environment
from run import compare, free_ports, in_turn, machine, short, table, write
from video import first_line, gst_has

RATE,PATIENCE = 15,20.          # pictures a second; s that a player may take longer than it must
SINKS = {'rtsp udp': 'RTSP, UDP', 'rtsp tcp': 'RTSP, TCP', 'rtp': 'RTP', 'ts udp': 'MPEG-TS, UDP', 'ts tcp': 'MPEG-TS, TCP'}
CODECS = dict(h264='H.264', h265='H.265')

def now_us(): return time.monotonic_ns()//1000          # one clock for all processes of the machine

# the pictures -------------------------------------------------------------------------------------------------------------------------

class Painted:
    "A source that paints `RATE` pictures a second, each with its number and the clock; it remembers the numbers"
    def __init__(self, width, height):
        import cv2, numpy as np
        ground = np.random.default_rng(0).integers(0, 255, (height//24,width//24,3), np.uint8)
        self.ground = cv2.resize(ground, (width,height), interpolation=cv2.INTER_CUBIC)
        self.began,self.numbers = time.monotonic(),[]

    @contextmanager
    def watching(self): yield

    def next(self, after=-1, timeout=None):
        import numpy as np
        from UAV.testing import mark
        number = max(after+1, math.ceil((time.monotonic()-self.began)*RATE))
        time.sleep(max(0, self.began+number/RATE-time.monotonic()))
        image = np.roll(self.ground, number*4, 1)
        self.numbers.append(number)
        return SimpleNamespace(image=mark(image, number, now_us()), number=number, time_utc=time.time())

# cameras: each is a process that says where it is, and at its end which numbers it has painted -----------------------------------------

def until_told(url, source, sdp=''):
    "Say that all is ready, wait for the end of our input, and give account"
    print(json.dumps(dict(url=url, sdp=sdp)), flush=True)
    sys.stdin.read()
    print(json.dumps(source.numbers), flush=True)

def our_camera(sink, codec, size, port, klv=True):
    "`Encoder` and one of its sinks; with `klv` each picture has a full set of metadata, as those of cameras have"
    from dataclasses import replace
    from UAV.utils.pose import Pose
    from UAV.video.klv import FrameMetadata
    from UAV.video.encoder import Encoder
    from UAV.video.senders import TSSender, TSServer
    from UAV.video.rtsp import RTPSender
    from UAV.video.rtsp_server import RTSPServer
    source = Painted(*size)
    seen = FrameMetadata.seen(Pose(-35.3632, 149.1652, 614., 30., 0., -45., 90.), 0., (60.,46.8), (2.,5.,0.), 'System 1', 'visible')
    with Encoder(source, codec, rate=RATE, hardware=False) as encoder:
        if klv: encoder.metadata_of = lambda frame, time_utc: replace(seen, time_utc=time_utc)
        if sink.startswith('rtsp'):
            with RTSPServer(port, '127.0.0.1') as server: return until_told(server.add('camera', encoder), source)
        if sink=='ts tcp':
            with TSServer(encoder, port, '127.0.0.1'): return until_told(f'tcp://127.0.0.1:{port}', source)
        with (RTPSender if sink=='rtp' else TSSender)('127.0.0.1', port) as sender:
            encoder.add(sender)
            until_told(f'udp://127.0.0.1:{port}', source, sender.sdp_file() if sink=='rtp' else '')

def gst_camera(sink, codec, size, port):
    "gst-rtsp-server at its best: an appsrc that keeps the newest picture only, and no delimiters, with which GStreamer's players wait for the next picture"
    from UAV.cameras.gst_pipeline import load_gst
    from UAV.video.units import sensible_bitrate
    Gst = load_gst()
    import gi
    gi.require_version('GstRtspServer', '1.0')
    from gi.repository import GLib, GstRtspServer
    source,kbit = Painted(*size),sensible_bitrate(*size, RATE, codec)//1000
    caps = f'video/x-raw,format=BGR,width={size[0]},height={size[1]},framerate={RATE}/1'
    factory = GstRtspServer.RTSPMediaFactory()
    factory.set_shared(True)
    factory.set_launch(f'( appsrc name=source is-live=true do-timestamp=true format=time leaky-type=downstream max-buffers=1 caps={caps} ! videoconvert n-threads=1 ! '
                       f'video/x-raw,format=I420 ! x264enc aud=false speed-preset=ultrafast tune=zerolatency threads=1 vbv-buf-capacity=500 key-int-max={RATE} bitrate={kbit} ! '
                       'rtph264pay name=pay0 pt=96 config-interval=-1 )')
    def feed(appsrc, ended):
        after = -1
        while not ended.is_set():
            frame = source.next(after)
            after = frame.number
            appsrc.emit('push-buffer', Gst.Buffer.new_wrapped(frame.image.tobytes()))
    def configure(_, media):
        ended = threading.Event()
        media.connect('unprepared', lambda _: ended.set())
        threading.Thread(target=feed, args=(media.get_element().get_child_by_name('source'),ended), daemon=True).start()
    factory.connect('media-configure', configure)
    server = GstRtspServer.RTSPServer(address='127.0.0.1', service=str(port))
    server.get_mount_points().add_factory('/camera', factory)
    server.attach(None)
    threading.Thread(target=GLib.MainLoop().run, daemon=True).start()
    until_told(f'rtsp://127.0.0.1:{port}/camera', source)

def ffmpeg_camera(sink, codec, size, port):
    "ffmpeg, which gets the pictures by a pipe and sends them"
    from UAV.video.units import sensible_bitrate
    source,rate = Painted(*size),sensible_bitrate(*size, RATE, codec)
    where = ['-f','rtp','-payload_type','96',f'rtp://127.0.0.1:{port}'] if sink=='rtp' else ['-f','mpegts','-flush_packets','1',f'udp://127.0.0.1:{port}?pkt_size=1316']
    line = ['ffmpeg','-loglevel','error','-probesize','32','-fflags','nobuffer','-f','rawvideo','-pixel_format','bgr24','-video_size',f'{size[0]}x{size[1]}',
            '-framerate',str(RATE),'-i','-','-pix_fmt','yuv420p','-c:v','libx264','-preset','ultrafast','-tune','zerolatency','-threads','1','-b:v',str(rate),
            '-maxrate',str(rate),'-bufsize',str(rate//2),'-g',str(RATE),'-x264-params','repeat-headers=1',*where]
    process = subprocess.Popen(line, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL)
    def feed():
        after = -1
        while True:
            frame = source.next(after)
            after = frame.number
            process.stdin.write(frame.image.tobytes())
            process.stdin.flush()
    threading.Thread(target=feed, daemon=True).start()
    try: until_told(f'udp://127.0.0.1:{port}', source)
    finally: process.kill()

CAMERAS = dict(UAV=our_camera, plain=partial(our_camera, klv=False), gst=gst_camera, ffmpeg=ffmpeg_camera)

# players: each is a process that says when it opened the stream, and what it saw when ---------------------------------------------------

def watch(images, count, opened):
    "`[number, painted µs, seen µs]` of the first `count` images; of one that cannot be read only when it was seen"
    from UAV.testing import read_mark
    seen,until = [],time.monotonic()+count/RATE+PATIENCE
    for image in images:
        at = now_us()
        seen.append([*(read_mark(image) or (None,None)), at])
        if len(seen)>=count or time.monotonic()>until: break
    print(json.dumps(dict(opened=opened, seen=seen)), flush=True)
    os._exit(0)         # as a viewer does who pulls the plug: closing is not measured

def pyav_player(sink, url, sdp, count):
    "PyAV, with the options of our how-to for ffplay"
    import av
    options = dict(analyzeduration='1000000', flags='low_delay', protocol_whitelist='file,udp,rtp,tcp')
    if sink.startswith('rtsp'): options['rtsp_transport'] = sink.split()[1]
    opened = now_us()
    def images():
        with av.open(sdp or url, options=options) as container:
            for picture in container.decode(video=0): yield picture.to_ndarray(format='bgr24')
    watch(images(), count, opened)

def our_player(sink, url, sdp, count):
    "`Player`, told to hand out each picture, so that we see what the way loses"
    from UAV.video.player import Player
    opened = now_us()
    with Player(sdp or url, newest=False, transport=sink.split()[1] if sink.startswith('rtsp') else None) as player: watch((frame.image for frame in player), count, opened)

def qgc_source(sink, url, codec, buffer):
    "What QGroundControl builds for each type of URI; `buffer`: without its low-latency mode"
    port = url.rsplit(':', 1)[1]
    if sink=='ts tcp': return f'tcpclientsrc host=127.0.0.1 port={port} ! tsdemux'
    if sink=='ts udp': return f'udpsrc uri=udp://0.0.0.0:{port} ! tsdemux'
    if sink.startswith('rtsp'): return f'rtspsrc location={url} latency=17 udp-reconnect=1 timeout=5000000 protocols={sink.split()[1]}'
    caps = f'application/x-rtp,media=(string)video,clock-rate=(int)90000,encoding-name=(string){codec.upper()}'
    return f'udpsrc uri=udp://0.0.0.0:{port} caps={caps}'+' ! rtpjitterbuffer'*buffer

def qgc_player(sink, url, sdp, count, codec, buffer=False):
    "QGroundControl's pipeline with an appsink at its end; with `buffer` a picture counts when it would be shown"
    from UAV.cameras.gst_pipeline import load_gst
    import numpy as np
    Gst = load_gst()
    opened = now_us()
    pipeline = Gst.parse_launch(f'{qgc_source(sink, url, codec, buffer)} ! parsebin ! tee ! queue ! valve drop=false ! decodebin3 ! videoconvert ! '
                                f'video/x-raw,format=BGR ! appsink name=out sync={str(buffer).lower()}')
    out,bus = pipeline.get_by_name('out'),pipeline.get_bus()
    pipeline.set_state(Gst.State.PLAYING)
    def images():
        while True:
            sample = out.emit('try-pull-sample', 5*Gst.SECOND)
            if sample is None: return print(said.parse_error() if (said := bus.pop_filtered(Gst.MessageType.ERROR)) else 'no picture for 5 s', file=sys.stderr)
            caps,data = sample.get_caps().get_structure(0),sample.get_buffer()
            yield np.frombuffer(data.extract_dup(0, data.get_size()), np.uint8).reshape(caps.get_value('height'), caps.get_value('width'), 3)
    watch(images(), count, opened)

def vlc_player(sink, url, sdp, count):
    "VLC, which writes each picture that it would show to a file; the file's time counts. Its time from opening has the start of the program in it"
    import cv2
    with tempfile.TemporaryDirectory(dir='/dev/shm' if Path('/dev/shm').is_dir() else None) as folder:
        os.chmod(folder, 0o777)
        options = f'-I dummy --quiet --no-audio --vout=dummy --video-filter=scene --scene-ratio=1 --scene-format=jpg --scene-path={folder} --run-time={count/RATE+1:.0f}'
        user = dict(user='nobody', env=dict(os.environ, HOME=folder)) if os.getuid()==0 else {}              # it refuses to run as root
        opened,offset = now_us(),time.time_ns()-time.monotonic_ns()
        subprocess.run(['cvlc',*options.split(),url.replace('udp://', 'udp://@'),'vlc://quit'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=count/RATE+PATIENCE, **user)
        files = sorted(Path(folder).glob('*.jpg'), key=lambda f: f.stat().st_mtime_ns)
        from UAV.testing import read_mark
        seen = [[*(read_mark(cv2.imread(str(f))) or (None,None)), (f.stat().st_mtime_ns-offset)//1000] for f in files]
    print(json.dumps(dict(opened=opened, seen=seen)), flush=True)

PLAYERS = {'PyAV': pyav_player, 'QGroundControl, low latency': qgc_player, 'QGroundControl, as shown': qgc_player, 'VLC': vlc_player, 'our Player': our_player}

def player_args(player, sink, codec):
    return dict(codec=codec, buffer=player.endswith('as shown')) if player.startswith('QGround') else {}

def installed(codec):
    "The players that this machine has; what is absent is said"
    absent = set()
    if not shutil.which('cvlc'): absent.add('VLC')
    if not all(gst_has(e) for e in ('rtspsrc','tsdemux','parsebin','decodebin3',f'avdec_{codec}')): absent |= {p for p in PLAYERS if p.startswith('QGround')}
    for p in sorted(absent): print(f'{p}: not on this machine, skipped', file=sys.stderr)
    return [p for p in PLAYERS if p not in absent]

# one camera, one player ---------------------------------------------------------------------------------------------------------------

def start(**told):
    "A process of this script"
    return subprocess.Popen([sys.executable, __file__, '--worker', json.dumps(told)], env=dict(environment(), PYTHONPATH=environment()['UAV_TREE']),
                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

@contextmanager
def camera(who, sink, codec, size):
    "A camera process: where it is; after the `with` also the numbers that it has painted"
    process = start(camera=who, sink=sink, codec=codec, size=size, port=free_ports(2)//2*2)
    try:
        if not select.select([process.stdout], [], [], 30)[0]: raise RuntimeError(f'{who} camera, {sink}: does not start')
        found = SimpleNamespace(**json.loads(process.stdout.readline()), painted=())
        yield found
        process.stdin.close()
        found.painted = json.loads(process.stdout.readline())
    finally:
        process.kill()
        process.wait()
        for f in (process.stdin,process.stdout): f.close()

def play(player, sink, codec, at, count):
    "What a player saw of the camera that is `at`"
    with tempfile.NamedTemporaryFile('w', suffix='.sdp') as file:
        file.write(at.sdp)
        file.flush()
        process = start(player=player, sink=sink, url=at.url, sdp=file.name if at.sdp else '', count=count, **player_args(player, sink, codec))
        try: said,_ = process.communicate(timeout=count/RATE+2*PATIENCE)
        except subprocess.TimeoutExpired: said = ''
        finally:
            process.kill()
            process.wait()
    return json.loads(said) if said else dict(opened=0, seen=[])

def judge(run, painted):
    "Counts and times of one run; lost: painted between the first and the last that came, and never seen. Late: of those painted since the first was seen"
    read = [s for s in run['seen'] if s[0] is not None]
    if not read: return dict(pictures=0)
    numbers = [s[0] for s in read]
    between = {n for n in painted if min(numbers)<=n<=max(numbers)}
    once = {n: (then,at) for n,then,at in reversed(read)}               # the first time that each was seen
    late = sorted((at-then)/1000 for then,at in once.values() if then>read[0][2]) or [(read[-1][2]-read[-1][1])/1000]
    return dict(pictures=len(read), lost=len(between-set(numbers)), repeated=len(numbers)-len(set(numbers)), unreadable=len(run['seen'])-len(read),
                disordered=sum(b<a for a,b in zip(numbers, numbers[1:])), p50=short(statistics.median(late)), p95=short(late[int(.95*(len(late)-1)+.5)]),
                first=short((read[0][2]-run['opened'])/1e6))

def run_all(who, sink, codec, size, count, players):
    "`{player: what it saw}`, one after the other at one camera"
    with camera(who, sink, codec, size) as at: seen = {p: play(p, sink, codec, at, count) for p in players}
    return {p: judge(run, at.painted) for p,run in seen.items()}

# all of it ----------------------------------------------------------------------------------------------------------------------------

CASES = [(sink,'h264') for sink in SINKS]+[('rtsp tcp','h265'),('rtp','h265'),('ts udp','h265')]
PEERS = [('rtsp udp','gst'),('rtsp tcp','gst'),('rtp','ffmpeg'),('ts udp','ffmpeg')]
NAMES = dict(gst='gst-rtsp-server', ffmpeg='ffmpeg')

def line(name, got):
    "A case as text"
    for player,r in got.items():
        if not r['pictures']: yield f'{name:22}{player:30} NO PICTURE'
        else: yield (f"{name:22}{player:30}{r['pictures']:4} pictures, lost {r['lost']}, repeated {r['repeated']}, disordered {r['disordered']}, unreadable {r['unreadable']}; "
                     f"{r['p50']:.0f} ms, 95 % {r['p95']:.0f}; first after {r['first']:.2f} s")

def can_serve(peer):
    "Is the peer on this machine? If not, that is said"
    check = "import gi; gi.require_version('GstRtspServer', '1.0')"
    if peer=='ffmpeg': there = shutil.which('ffmpeg')
    else: there = gst_has('x264enc') and subprocess.run([sys.executable,'-c',f'from UAV.cameras.gst_pipeline import load_gst; load_gst(); {check}'], env=dict(os.environ, PYTHONPATH=environment()['UAV_TREE']),
                                                        stderr=subprocess.DEVNULL).returncode==0
    if not there: print(f'{NAMES[peer]}: not on this machine, skipped', file=sys.stderr)
    return there

def beside(sink, peer, size, rounds, count, player):
    "Rows: latency, and for RTSP the time to the first picture, which has no target; ours and a peer's in turn, watched by the same player"
    got = in_turn(dict(UAV='UAV', peer=peer), rounds, lambda who: run_all(who, sink, 'h264', size, count, [player])[player])
    pairs = [(a,b) for a,b in zip(got['UAV'], got['peer']) if a['pictures'] and b['pictures']]
    if not pairs: return [],[]
    ours,theirs = ([{k: r[k] for k in ('p50','p95','first')} for r in side] for side in zip(*pairs))
    def row(name, unit, key): return compare(f'{name}, {SINKS[sink]}', player, NAMES[peer], unit, ours, theirs, 1., key=key)
    first = [row('first picture', 's', 'first')] if sink.startswith('rtsp') else []
    return [row('latency', 'ms', 'p50')],[{k: v for k,v in r.items() if k not in ('target','reached')} for r in first]

def versions():
    import av
    return dict(av=av.__version__, ffmpeg=first_line('ffmpeg','-version'), gstreamer=first_line('gst-launch-1.0','--version'), vlc=first_line('cvlc','--version') if os.getuid() else vlc_version())

def vlc_version():
    said = subprocess.run(['dpkg-query','-W','-f','${Version}','vlc-bin'], capture_output=True, text=True).stdout if shutil.which('dpkg-query') else ''
    return said or ('there' if shutil.which('cvlc') else 'absent')

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--quick', action='store_true', help='few pictures, one round: to see that it works, not to quote')
    parser.add_argument('--only', choices=[f'{codec} {sink}' for sink,codec in CASES]+['peers'], help='one case; writes nothing without --out')
    parser.add_argument('--plain', action='store_true', help='our camera without metadata (KLV)')
    parser.add_argument('--out', help='where the results go (players.json)')
    parser.add_argument('--worker', type=json.loads, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if told := args.worker: return (CAMERAS[told.pop('camera')] if 'camera' in told else PLAYERS[told.pop('player')])(**told)
    size,count,rounds = ((320,240),30,1) if args.quick else ((640,480),60,3)
    results = dict(machine=dict(machine(), **versions()), quick=args.quick, size=size, rate=RATE, count=count, load=[os.getloadavg()[1]], rows=[], first=[], detail={})
    players = {codec: installed(codec) for codec in CODECS}
    for sink,codec in CASES:
        if args.only not in (None, f'{codec} {sink}'): continue
        who = [p for p in players[codec] if p!='VLC' or sink.startswith('ts')]              # Debian builds VLC without RTSP
        got = results['detail'][f'{SINKS[sink]}, {CODECS[codec]}'] = run_all('plain' if args.plain else 'UAV', sink, codec, size, count, who)
        for l in line(f'{codec} {sink}', got): print(l, flush=True)
    peers = {peer for peer in NAMES if can_serve(peer)}
    for sink,peer in PEERS if args.only in (None,'peers') else ():
        if peer not in peers: continue
        watchers = [p for p in players['h264'][:2] if (sink,p)!=('rtp','PyAV')]                # FFmpeg wants an SDP, that another ffmpeg does not give in time
        for p in watchers:
            rows,first = beside(sink, peer, size, rounds, count, p)
            results['rows'] += rows
            results['first'] += first
            for l in table(rows): print(l, flush=True)
    results['load'].append(os.getloadavg()[1])
    if args.out or not args.only: write(args.out or HERE/'players.json', results)

if __name__=='__main__': main()
