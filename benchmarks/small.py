"""What a small computer feels: a served camera with nobody there, with a viewer, with two pictures a second, and with the panel open, each beside peers that do the same work. See README.md."""
import argparse, asyncio, atexit, json, os, re, shutil, subprocess, sys, tempfile, threading, time
from contextlib import ExitStack, contextmanager
from functools import cache
from pathlib import Path

import psutil
from trees import HERE, TREE, environment
from run import compare, free_ports, in_turn, machine, middle, short, table, write
from video import KEPT, gst_has, versions, write_frames

SIZE,RATE,EVERY = (1280,720),15,.5              # px; pictures a second; s between two stills
PATIENCE,TOKEN = 30.,'small-computer'
IN_MEMORY = '/dev/shm' if Path('/dev/shm').is_dir() else None

# ours: each is a process of this script -------------------------------------------------------------------------------------------------

def raw_camera(folder, storage):
    "A camera that reads the next raw picture from its file when it is asked to: what a driver costs at the least"
    import numpy as np
    from UAV.cameras.camera import Camera
    from UAV.cameras.values import CameraInformation, Frame
    class Raw(Camera):
        information,frame_rate,number = CameraInformation('UAV', 'Raw', resolution_h=SIZE[0], resolution_v=SIZE[1]),float(RATE),0
        def __init__(self, **storage):
            super().__init__(**storage)
            self.images = [np.empty((SIZE[1],SIZE[0],3), np.uint8) for _ in range(4)]           # as many as a driver has
        def read(self):
            self.number += 1
            image = self.images[self.number%4]
            with open(f'{folder}/{self.number%KEPT}.raw', 'rb', buffering=0) as file: file.readinto(image)
            return Frame(image, self.number, time.time())
    return Raw(**storage)

def server(folder, port, rtsp, camera='raw://here'):
    "`uav-camera-server`, as it is typed, with this camera or another one"
    from UAV.cli.serve import main
    from UAV.utils.devices import register_device
    register_device('raw', lambda url, **storage: raw_camera(folder, storage))
    main(['--camera',camera,'--connection',f'udpout:127.0.0.1:{port}','--rtsp',str(rtsp),'--rate',str(RATE),'--folder',f'{folder}/pictures'])

def panel(port, page):
    "`uav-gui`, as it is typed"
    from UAV.cli.gui import main
    main(['--connection',f'udpin:127.0.0.1:{port}','--port',str(page),'--token',TOKEN])

def our_source(folder):
    "The camera alone: frames are read, and nobody does anything with them"
    with raw_camera(folder, dict(folder=f'{folder}/pictures')) as camera, camera.frames.watching():
        number = -1
        while True: number = camera.frames.next(number).number

# theirs ---------------------------------------------------------------------------------------------------------------------------------

def bitrate():
    from UAV.video.units import sensible_bitrate
    return sensible_bitrate(*SIZE, RATE, 'h264')

def raw_input(folder, rate=RATE):
    return ['-re','-stream_loop','-1','-f','rawvideo','-pixel_format','bgr24','-video_size','{}x{}'.format(*SIZE),'-framerate',str(rate),'-i',f'{folder}/all.raw']

FFMPEG = ['ffmpeg','-nostdin','-y','-loglevel','error']
@cache
def film(folder):
    "A film of half a minute, of 30 pictures a second, and not below /dev, where devices are; without ffmpeg there is none"
    path = f'{tempfile.mkdtemp()}/film.mp4'
    atexit.register(shutil.rmtree, Path(path).parent)
    line = [*FFMPEG,*raw_input(folder, 30)[1:],'-frames:v','900','-pix_fmt','yuv420p','-c:v','libx264','-preset','ultrafast','-g','30',path]
    subprocess.run(line, check=True)
    return path
def ffmpeg_film(folder): return [*FFMPEG,'-re','-stream_loop','-1','-threads','1','-i',film(folder),'-f','null','-']
def ffmpeg_source(folder): return [*FFMPEG,*raw_input(folder),'-c','copy','-f','null','-']
def ffmpeg_viewer(folder, port):
    "ffmpeg is no RTSP server: it serves MPEG-TS over TCP to the one viewer that connects"
    return [*FFMPEG,*raw_input(folder),'-pix_fmt','yuv420p','-c:v','libx264','-preset','ultrafast','-tune','zerolatency','-threads','1','-b:v',str(bitrate()),
            '-maxrate',str(bitrate()),'-bufsize',str(bitrate()//2),'-g',str(RATE),'-f','mpegts','-flush_packets','1',f'tcp://127.0.0.1:{port}?listen=1']
def ffmpeg_stills(folder): return [*FFMPEG,*raw_input(folder, 1/EVERY),'-c:v','mjpeg','-q:v','2','-pix_fmt','yuvj420p','-threads','1',f'{folder}/pictures/%06d.jpg']
def ffmpeg_page(url, port):
    return [*FFMPEG,'-rtsp_transport','tcp','-threads','1','-i',url,'-c:v','mjpeg','-q:v','5','-pix_fmt','yuvj420p','-threads','1','-f','mpjpeg','-listen','1',f'http://127.0.0.1:{port}']

def gst_raw(folder, rate=RATE):
    "`multifilesrc` alone has no pace: its segment counts in bytes"
    return f'multifilesrc location={folder}/%d.raw loop=true stop-index={KEPT-1} ! rawvideoparse format=bgr width={SIZE[0]} height={SIZE[1]} framerate={rate}/1 ! clocksync'
def gst_source(folder): return ['gst-launch-1.0','-q',*f'{gst_raw(folder)} ! fakesink'.split()]
def gst_stills(folder):
    return ['gst-launch-1.0','-q',*f'{gst_raw(folder, round(1/EVERY))} ! videoconvert n-threads=1 ! jpegenc quality=95 ! multifilesink location={folder}/pictures/%06d.jpg'.split()]
def gst_page(url, port):
    return ['gst-launch-1.0','-q',*f'rtspsrc location={url} protocols=tcp latency=0 ! rtph264depay ! h264parse ! avdec_h264 max-threads=1 ! videoconvert n-threads=1 ! '
            f'jpegenc quality=75 ! multipartmux boundary=next ! tcpserversink host=127.0.0.1 port={port}'.split()]

def gst_rtsp(folder, port):
    "gst-rtsp-server with the same pictures; its pipeline runs while somebody watches"
    from UAV.cameras.gst_pipeline import load_gst
    load_gst()
    import gi
    gi.require_version('GstRtspServer', '1.0')
    from gi.repository import GLib, GstRtspServer
    factory = GstRtspServer.RTSPMediaFactory()
    factory.set_shared(True)
    factory.set_launch(f'( {gst_raw(folder)} ! videoconvert n-threads=1 ! video/x-raw,format=I420 ! x264enc speed-preset=ultrafast tune=zerolatency threads=1 vbv-buf-capacity=500 '
                       f'key-int-max={RATE} bitrate={bitrate()//1000} ! rtph264pay name=pay0 pt=96 config-interval=-1 )')
    server = GstRtspServer.RTSPServer(address='127.0.0.1', service=str(port))
    server.get_mount_points().add_factory('/raw_1', factory)
    server.attach(None)
    GLib.MainLoop().run()

def stills_by_opencv(folder):
    "Read the next picture, and write it as a JPEG: what a program of one's own does"
    import cv2, numpy as np
    image,count = np.empty((SIZE[1],SIZE[0],3), np.uint8),0
    def take():
        nonlocal count
        with open(f'{folder}/{count%KEPT}.raw', 'rb', buffering=0) as file: file.readinto(image)
        cv2.imwrite(f'{folder}/pictures/{count:06}.jpg', image, [cv2.IMWRITE_JPEG_QUALITY,95])
        count += 1
    return take

def pymavlink_camera(port, folder=''):
    "The least camera that one writes with pymavlink: heartbeat, acknowledgements, CAMERA_IMAGE_CAPTURED; with `folder` it takes the pictures, too"
    from pymavlink import mavutil
    from pymavlink.dialects.v20 import ardupilotmega as mavlink
    take = stills_by_opencv(folder) if folder else lambda: None
    conn = mavutil.mavlink_connection(f'udpout:127.0.0.1:{port}', source_system=1, source_component=100)
    interval,due,beat,count = 0.,0.,0.,0
    while True:
        now = time.monotonic()
        if now>=beat:
            conn.mav.heartbeat_send(mavlink.MAV_TYPE_CAMERA, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, mavlink.MAV_STATE_ACTIVE)
            beat = now+1
        if interval and now>=due:
            take()
            conn.mav.camera_image_captured_send(int(now*1000)&0xffffffff, int(time.time()*1e6), 0, 0, 0, 0, 0, [1,0,0,0], count, 1, b'')
            count,due = count+1,due+interval
        msg = conn.recv_match(type='COMMAND_LONG', blocking=True, timeout=max(.001, min(beat, due if interval else beat)-time.monotonic()))
        if msg is None: continue
        if msg.command==mavlink.MAV_CMD_IMAGE_START_CAPTURE: interval,due = msg.param2,time.monotonic()
        conn.mav.command_ack_send(msg.command, mavlink.MAV_RESULT_ACCEPTED)

def mavsdk_camera(port):
    "MAVSDK's camera server, whose callbacks answer at once: no picture is taken"
    import mavsdk
    from mavsdk.plugins.camera_server import CameraFeedback, CameraServer, CaptureInfo, Information, Position, Quaternion
    mavsdk.log_subscribe(lambda *_: True)
    sdk = mavsdk.Mavsdk(mavsdk.Configuration.create_manual(1, 100, True))
    sdk.add_any_connection_with_handle(f'udpout://127.0.0.1:{port}')
    camera = CameraServer(sdk.server_component_by_type(mavsdk.ComponentType.CAMERA))
    camera.set_information(Information(vendor_name='MAVSDK', model_name='Least', firmware_version='1.0.0.0', focal_length_mm=3., horizontal_sensor_size_mm=4., vertical_sensor_size_mm=3.,
        horizontal_resolution_px=SIZE[0], vertical_resolution_px=SIZE[1], lens_id=0, definition_file_version=0, definition_file_uri='',
        image_in_video_mode_supported=True, video_in_image_mode_supported=True))
    taken = 0
    def take(index, *_):
        nonlocal taken
        camera.respond_take_photo(CameraFeedback.OK, CaptureInfo(position=Position(0, 0, 0, 0), attitude_quaternion=Quaternion(1, 0, 0, 0),
                                                                 time_utc_us=int(time.time()*1e6), index=taken, is_success=True, file_url=''))
        taken += 1
    camera.subscribe_take_photo(take)
    threading.Event().wait()

# what a picture of the stream takes, counted --------------------------------------------------------------------------------------------

def pictures(folder, count, size):
    "`count` pictures from the camera to the packets of one RTSP viewer, one after the other on one thread"
    import socket
    from UAV.video.encoder import Encoder, _Pace
    from UAV.video.rtsp import _RTPStream
    from UAV.video.rtsp_server import _InsideViewer
    from UAV.video.senders import _Outbox
    import numpy as np
    ours,theirs = socket.socketpair()
    for sock in (ours,theirs):
        sock.setblocking(False)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1<<21)
    viewer = _InsideViewer(_RTPStream(), 'counted', lambda: None, _Outbox(ours), (0,1))
    class Direct:
        def put(self, unit):
            viewer.send(unit)
            theirs.recv(1<<22)
    camera = raw_camera(folder, dict(folder=f'{folder}/pictures'))
    if size!=SIZE:
        dark = np.zeros((size[1],size[0],3), np.uint8)
        camera.images = [dark]*4
        from UAV.cameras.values import Frame
        def read():
            camera.number += 1
            return Frame(dark, camera.number, 0.)
        camera.read = read
    encoder = Encoder(camera.frames, rate=1e6, key_interval=1e9, bitrate=bitrate(), hardware=False)       # all are taken, and only the first is a key frame
    encoder._sinks[Direct()],pace,camera.frames.watchers = True,_Pace(time.monotonic()-1, 1e6),1
    for _ in range(count):
        camera.frames._read_one()
        encoder._take(camera.frames.next(encoder._number, 1), time.monotonic(), pace)
    os._exit(0)

def instructions(line, tree=None):
    "Those that a process carries out, all its threads, by Valgrind"
    if isinstance(line, dict): line = [sys.executable, __file__, '--worker', json.dumps(line)]
    said = subprocess.run(['valgrind','--tool=callgrind','--callgrind-out-file=/dev/null',*line], env=dict(environment(tree), PYTHONPATH=str(tree or TREE)), stdin=subprocess.DEVNULL,
                          capture_output=True, text=True).stderr
    found = re.search(r'Collected : (\d+)', said)
    if not found: raise RuntimeError(f'{line[:2]}: {said[-500:]}')
    return int(found[1])

def counted(folder, before, few=5, many=25):
    "`{who: thousands of instructions for a picture}`: a run of `many` less one of `few`; dark pictures of 64×48 cost nothing, so what remains is ours"
    if not shutil.which('valgrind'): return print('valgrind: not on this machine, skipped', file=sys.stderr)
    def ours(size, tree=None): return lambda count: instructions(dict(kind='pictures', folder=folder, count=count, size=size), tree)
    def ffmpeg(count):
        line = ffmpeg_viewer(folder, 0)
        return instructions([*line[:line.index('-f', line.index('-g'))],'-frames:v',str(count),'-f','mpegts',f'{folder}/counted.ts'])
    who = {'UAV, 64x48':ours((64,48)), 'UAV':ours(SIZE)}
    if before: who |= {'UAV before, 64x48':ours((64,48), before), 'UAV before':ours(SIZE, before)}
    if shutil.which('ffmpeg'): who['ffmpeg'] = ffmpeg
    return {name: dict(kilo=short((count(many)-count(few))/(many-few)/1e3)) for name,count in who.items()}

WORKERS = dict(pictures=pictures, server=server, panel=panel, our_source=our_source, gst_rtsp=gst_rtsp, pymavlink_camera=pymavlink_camera, mavsdk_camera=mavsdk_camera)

# who asks and who looks: none of them is counted --------------------------------------------------------------------------------------

class Station:
    "A ground station by pymavlink: it beats, and counts what the camera has taken"
    def __init__(self, port):
        from pymavlink import mavutil
        self.conn,self.taken,self.cameras,self.ended = mavutil.mavlink_connection(f'udpin:127.0.0.1:{port}', source_system=255, source_component=190),0,0,False
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        from pymavlink.dialects.v20 import ardupilotmega as mavlink
        beat = 0.
        while not self.ended:
            if time.monotonic()>=beat and self.cameras:
                self.conn.mav.heartbeat_send(mavlink.MAV_TYPE_GCS, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, 4)
                beat = time.monotonic()+1
            msg = self.conn.recv_match(blocking=True, timeout=.2)
            if msg is None: continue
            self.cameras += msg.get_type()=='HEARTBEAT' and msg.get_srcComponent()==100
            self.taken += msg.get_type()=='CAMERA_IMAGE_CAPTURED'
        self.conn.close()

    def start_capture(self):
        "Two pictures a second from now on"
        until(lambda: self.cameras, 'heartbeat')
        before,tries = self.taken,0
        while self.taken==before:
            self.conn.mav.command_long_send(1, 100, 2000, tries, 0, EVERY, 0, 0, 0, 0, 0)
            tries += 1
            time.sleep(3*EVERY)
            if tries>9: raise TimeoutError('no picture was taken')

    def close(self):
        self.ended = True
        self.thread.join(5)

def until(ready, what, patience=PATIENCE):
    end = time.monotonic()+patience
    while not ready():
        if time.monotonic()>end: raise TimeoutError(f'no {what} in {patience:g} s')
        time.sleep(.05)

class Viewer:
    "ffmpeg, which takes a stream as it is, and counts its pictures"
    def __init__(self, url, *options):
        line = ['ffmpeg','-nostdin','-loglevel','error',*options,'-i',url,'-c','copy','-f','null','-progress','pipe:1','-stats_period','0.2','-']
        self.process,self.seen = subprocess.Popen(line, stdout=subprocess.PIPE, text=True),0
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            if line.startswith('frame='): self.seen = int(line[6:])

    def close(self):
        self.process.kill()
        self.process.wait()

class Page:
    "What the panel's page does, without drawing: it polls by the WebSocket, for the next picture as soon as one is there"
    def __init__(self, port):
        self.seen,self.fault,self.ended = 0,None,False
        self.thread = threading.Thread(target=lambda: asyncio.run(self.watch(port)), daemon=True)
        self.thread.start()

    async def watch(self, port):
        import aiohttp
        tag,after = '',{}
        async with aiohttp.ClientSession() as session, session.ws_connect(f'http://127.0.0.1:{port}/socket', max_msg_size=0) as socket:
            await socket.send_json(dict(kind='token', token=TOKEN))
            while not self.ended:
                await socket.send_json(dict(kind='poll', ref=1, seen=tag, after=after))
                data = (await socket.receive()).data
                told = json.loads(data if isinstance(data, str) else data[4:4+int.from_bytes(data[:4], 'big')])
                tag = told['tag']
                if told['status']: after = {row['id']: after.get(row['id'], -1) for row in told['status']['cameras']}
                for id,number,*_ in told['pictures']: after[id],self.seen = number,self.seen+1

    def close(self):
        self.ended = True
        self.thread.join(5)

class Multipart:
    "A browser at an MJPEG page: it counts the beginnings of JPEGs"
    def __init__(self, port, asks):
        import socket
        def there():
            try: self.sock = socket.create_connection(('127.0.0.1',port), 5)
            except OSError: return False
            return True
        until(there, 'page')
        if asks: self.sock.sendall(b'GET / HTTP/1.1\r\nHost: here\r\n\r\n')
        self.seen = 0
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        try:
            while data := self.sock.recv(1<<18): self.seen += data.count(b'\xff\xd8\xff')
        except OSError: pass

    def close(self): self.sock.close()

# one process, and what it takes -------------------------------------------------------------------------------------------------------

def used(pid):
    "CPU seconds of a process so far, user and system, all its threads (also those that have ended), to the nanosecond; Linux"
    return time.clock_gettime((~pid)<<3|2)

def wakeups(pid):
    "How often its threads have begun to wait"
    return sum(int(re.search(r'^voluntary_ctxt_switches:\s*(\d+)', f.read_text(), re.M)[1]) for f in Path(f'/proc/{pid}/task').glob('*/status'))

@contextmanager
def started(line, tree=None, log=None):
    "A process; a dict is a worker of this script"
    if isinstance(line, dict): line = [sys.executable, __file__, '--worker', json.dumps(line)]
    env = dict(environment(tree), PYTHONPATH=str(tree or TREE), PYTHONUNBUFFERED='1', GST_DEBUG='0')
    process = subprocess.Popen(line, env=env, stdin=subprocess.DEVNULL, stdout=log or subprocess.DEVNULL, stderr=log or subprocess.STDOUT)
    try: yield process
    finally:
        process.kill()
        process.wait()

class Load:
    "A contender of a load: a process that is measured, and the others that make it work"
    def __init__(self, folder, seconds, warm): self.folder,self.seconds,self.warm = folder,seconds,warm

    def measure(self, start):
        "`start(stack)` gives the process and what counts its pictures, or `None`"
        with ExitStack() as stack:
            shutil.rmtree(f'{self.folder}/pictures', ignore_errors=True)
            Path(f'{self.folder}/pictures').mkdir()
            process,counter = start(stack)
            if counter: until(lambda: counter()>0, 'picture')
            time.sleep(self.warm)
            if process.poll() is not None: raise RuntimeError(f'{process.args[:2]} has ended')
            before,began,seen,woke = used(process.pid),time.monotonic(),counter and counter(),wakeups(process.pid)
            time.sleep(self.seconds)
            after,took,count,wakes = used(process.pid),time.monotonic()-began,counter and counter(),wakeups(process.pid)
            facts = psutil.Process(process.pid)
            found = dict(cpu=100*(after-before)/took, threads=facts.num_threads(), rss=facts.memory_info().rss/2**20, wakeups=max(0, wakes-woke)/took)
            if counter:
                found['rate'] = (count-seen)/took
                found['ms'] = 1e3*(after-before)/max(1, count-seen)
            return found

    def run(self, stack, line, tree=None): return stack.enter_context(started(line, tree))
    def keep(self, stack, one):
        stack.callback(one.close)
        return one

    def serve(self, stack, tree=None, mavlink=None, **more):
        "Our server: `(process, its RTSP URL)`, once it answers there"
        rtsp = free_ports()
        process = self.run(stack, dict(kind='server', folder=self.folder, port=mavlink or free_ports(), rtsp=rtsp, **more), tree)
        until(lambda: listens(rtsp), 'server')
        return process,f'rtsp://127.0.0.1:{rtsp}/raw_1'

def listens(port):
    "Does somebody listen at this TCP port? It is not connected to"
    return any(line.split()[1].endswith(f':{port:04X}') and line.split()[3]=='0A' for name in ('tcp','tcp6') for line in Path(f'/proc/net/{name}').read_text().splitlines()[1:])

def shows(url): return lambda load,stack: load.keep(stack, Viewer(url, *(('-rtsp_transport','tcp') if url.startswith('rtsp') else ())))

# the loads ------------------------------------------------------------------------------------------------------------------------------

def idle(load):
    "Nobody watches, a ground station beats"
    def camera(kind, tree=None):
        def start(stack):
            port = free_ports()
            station = load.keep(stack, Station(port))
            process = load.serve(stack, tree, port)[0] if kind=='server' else load.run(stack, dict(kind=kind, port=port))
            until(lambda: station.cameras, 'heartbeat')
            return process,None
        return start
    def gst(stack):
        port = free_ports()
        process = load.run(stack, dict(kind='gst_rtsp', folder=load.folder, port=port))
        until(lambda: listens(port), 'server')
        return process,None
    return camera('server'),dict(before=lambda tree: camera('server', tree)),{'MAVSDK':camera('mavsdk_camera'), 'pymavlink':camera('pymavlink_camera'), 'gst-rtsp-server':gst}

def a_film(load):
    "A film of 30 pictures a second is the camera, and nobody watches; ffmpeg decodes it"
    def ours(tree=None): return lambda stack: (load.serve(stack, tree, camera=film(load.folder))[0], None)
    return ours(),dict(before=ours),{'ffmpeg':lambda stack: (load.run(stack, ffmpeg_film(load.folder)), None)}

def source(load):
    "The pictures are read, and nothing is done with them"
    def one(line, tree=None): return lambda stack: (load.run(stack, line, tree), None)
    ours = dict(kind='our_source', folder=load.folder)
    return one(ours),dict(before=lambda tree: one(ours, tree)),{'ffmpeg':one(ffmpeg_source(load.folder)), 'GStreamer':one(gst_source(load.folder))}

def viewer(load):
    "One viewer of the H.264 stream"
    def ours(tree=None):
        def start(stack):
            process,url = load.serve(stack, tree)
            watcher = shows(url)(load, stack)
            return process,lambda: watcher.seen
        return start
    def gst(stack):
        port = free_ports()
        process = load.run(stack, dict(kind='gst_rtsp', folder=load.folder, port=port))
        until(lambda: listens(port), 'server')
        watcher = shows(f'rtsp://127.0.0.1:{port}/raw_1')(load, stack)
        return process,lambda: watcher.seen
    def ffmpeg(stack):
        port = free_ports()
        process = load.run(stack, ffmpeg_viewer(load.folder, port))
        until(lambda: listens(port), 'server')
        watcher = shows(f'tcp://127.0.0.1:{port}')(load, stack)
        return process,lambda: watcher.seen
    return ours(),dict(before=ours),{'ffmpeg':ffmpeg, 'gst-rtsp-server':gst}

def capture(load):
    "Two pictures a second, each a JPEG on the disk and a message to the ground station"
    def camera(kind, tree=None, **more):
        def start(stack):
            port = free_ports()
            station = load.keep(stack, Station(port))
            process = load.serve(stack, tree, port)[0] if kind=='server' else load.run(stack, dict(kind=kind, port=port, **more))
            station.start_capture()
            return process,lambda: station.taken
        return start
    def files(line):
        def start(stack):
            process = load.run(stack, line)
            return process,lambda: len(os.listdir(f'{load.folder}/pictures'))
        return start
    return camera('server'),dict(before=lambda tree: camera('server', tree)),{
        'pymavlink and OpenCV':camera('pymavlink_camera', folder=load.folder), 'ffmpeg, no messages':files(ffmpeg_stills(load.folder)),
        'GStreamer, no messages':files(gst_stills(load.folder)), 'MAVSDK, no pictures':camera('mavsdk_camera'), 'pymavlink, no pictures':camera('pymavlink_camera')}

def page(load):
    "The panel's process, which decodes the stream and compresses it for a page that looks"
    def ours(tree=None):
        def start(stack):
            port,at = free_ports(),free_ports()
            process = load.run(stack, dict(kind='panel', port=port, page=at), tree)
            until(lambda: listens(at), 'panel')
            load.serve(stack, None, port)
            looks = load.keep(stack, Page(at))
            return process,lambda: looks.seen
        return start
    def peer(line, asks):
        def start(stack):
            _,url = load.serve(stack)
            at = free_ports()
            process = load.run(stack, line(url, at))
            looks = load.keep(stack, Multipart(at, asks))
            return process,lambda: looks.seen
        return start
    return ours(),dict(before=ours),{'ffmpeg':peer(ffmpeg_page, True), 'GStreamer':peer(gst_page, False)}

def served(load):
    "The server while the panel looks: one viewer, and what the panel asks over MAVLink"
    def ours(tree=None):
        def start(stack):
            port,at = free_ports(),free_ports()
            load.run(stack, dict(kind='panel', port=port, page=at))
            until(lambda: listens(at), 'panel')
            process,_ = load.serve(stack, tree, port)
            looks = load.keep(stack, Page(at))
            return process,lambda: looks.seen
        return start
    return ours(),dict(before=ours),{}

LOADS = dict(idle=idle, film=a_film, source=source, viewer=viewer, capture=capture, panel=page, served=served)
TARGETS = {('viewer','ffmpeg'):1.1, ('viewer','gst-rtsp-server'):1.1, ('capture','pymavlink and OpenCV'):1.5, ('panel','ffmpeg'):1.1, ('panel','GStreamer'):1.1, ('idle','pymavlink'):1.5, ('film','ffmpeg'):1.1}

def present(peers):
    "Those that this machine has; what is absent is said"
    def has(name):
        if 'ffmpeg' in name: return shutil.which('ffmpeg')
        if 'GStreamer' in name: return gst_has('avdec_h264') and gst_has('jpegenc')
        if 'MAVSDK' in name: return subprocess.run([sys.executable,'-c','import mavsdk'], stderr=subprocess.DEVNULL).returncode==0
        code = "from UAV.cameras.gst_pipeline import load_gst; load_gst(); import gi; gi.require_version('GstRtspServer', '1.0')"
        return 'gst' not in name or subprocess.run([sys.executable,'-c',code], env=dict(environment(), PYTHONPATH=str(TREE)), stderr=subprocess.DEVNULL).returncode==0
    for name in [n for n in peers if not has(n)]:
        print(f'{name}: not on this machine, skipped', file=sys.stderr)
        del peers[name]
    return peers

def measure(name, folder, rounds, seconds, warm, before):
    "`(rows, details)` of a load: all contenders in turn"
    load = Load(folder, seconds, warm)
    ours,again,peers = LOADS[name](load)
    who = {'UAV': ours, **({'UAV before': again['before'](before)} if before else {}), **present(peers)}
    got = in_turn(who, rounds, load.measure)
    rows = [compare(name, LOADS[name].__doc__, peer, '% CPU', got['UAV'], got[peer], TARGETS[name,peer], key='cpu', before=got.get('UAV before'))
            for peer in got if (name,peer) in TARGETS]
    def least(found): return dict(least=short(min(r['rate'] for r in found))) if 'rate' in found[0] else {}       # of the rounds: did pictures stall in one?
    return rows,{who: middle(found)|least(found) for who,found in got.items()}

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--before', type=Path, help='an older checkout, measured as well')
    parser.add_argument('--quick', action='store_true', help='one short round: to see that it works, not to quote')
    parser.add_argument('--rounds', type=int, default=5)
    parser.add_argument('--seconds', type=float, default=10.)
    parser.add_argument('--only', choices=[*LOADS,'counted'], help='one load; writes nothing without --out')
    parser.add_argument('--out', help='where the results go (small.json)')
    parser.add_argument('--worker', type=json.loads, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if told := args.worker: return WORKERS[told.pop('kind')](**{k: tuple(v) if k=='size' else v for k,v in told.items()})
    if args.before and not (args.before/'UAV').is_dir(): parser.error(f'{args.before} has no UAV')
    before = args.before and args.before.resolve()
    rounds,seconds,warm = (1,2.,.5) if args.quick else (args.rounds,args.seconds,3.)
    results = dict(machine=dict(machine(before), **versions()), quick=args.quick, size=SIZE, rate=RATE, every=EVERY, seconds=seconds, rounds=rounds, load=[os.getloadavg()[0]],
                   what={name: load.__doc__ for name,load in LOADS.items()}, rows=[], detail={})
    with tempfile.TemporaryDirectory(dir=IN_MEMORY) as folder:
        write_frames(Path(folder), *SIZE)
        for name in LOADS:
            if args.only not in (None, name) or name=='film' and not shutil.which('ffmpeg'): continue
            rows,results['detail'][name] = measure(name, folder, rounds, seconds, warm, before)
            results['rows'] += rows
            for who,facts in results['detail'][name].items(): print(f'{name:8}{who:24}', *(f'{k} {v:g}' for k,v in facts.items()), sep='  ', flush=True)
            for line in table([dict(r, where='') for r in rows]): print(line, flush=True)
        if (args.only=='counted' or not (args.quick or args.only)) and (found := counted(folder, before)):
            results['detail']['counted'] = found
            for who,facts in found.items(): print(f'counted {who:24}', *(f'{k} {v:g}' for k,v in facts.items()), sep='  ', flush=True)
    results['load'].append(os.getloadavg()[0])
    if args.out or not args.only: write(args.out or HERE/'small.json', results)

if __name__=='__main__': main()
