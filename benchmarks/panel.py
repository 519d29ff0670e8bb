"""From a painted picture to the pixels of a browser: our panel's page beside an MJPEG page and the bare stream; how late, and what it costs. See README.md."""
import argparse, json, os, select, statistics, subprocess, sys, threading, time
from contextlib import contextmanager
from types import SimpleNamespace

import psutil
from trees import HERE, environment
from run import compare, free_ports, in_turn, machine, middle, short, table, write

SIZE,RATE,QUALITY = (640,480),25,75
BITS = 1<<48                        # what a mark keeps of the clock, µs

def now_us(): return time.time_ns()//1000          # the browser has this clock, too

# the camera ---------------------------------------------------------------------------------------------------------------------------

def ground():
    "A textured picture"
    import cv2, numpy as np
    cells = np.random.default_rng(0).integers(0, 255, (SIZE[1]//24,SIZE[0]//24,3), np.uint8)
    return cv2.resize(cells, SIZE, interpolation=cv2.INTER_CUBIC)

def painted_camera():
    "A camera whose ground moves, with the number and the clock in each picture"
    import numpy as np
    from UAV.cameras.camera import Camera
    from UAV.cameras.values import CameraInformation, Frame
    from UAV.testing import mark
    class Painted(Camera):
        information,number,frame_rate = CameraInformation(model='Painted', resolution_h=SIZE[0], resolution_v=SIZE[1]),0,float(RATE)
        texture = ground()
        def read(self):
            self.number += 1
            image = np.roll(self.texture, self.number*4, 1)
            return Frame(mark(image, self.number, now_us()), self.number, time.time())
    return Painted()

def tell(**facts): print(json.dumps(facts), flush=True)

def camera(port):
    "A camera server: MAVLink, and one RTSP stream"
    from UAV.mavlink import CameraServer, MAVCom
    with painted_camera() as painted, MAVCom(f'udpout:127.0.0.1:{port}', source_system=1) as com:
        stream = painted.add_stream(port=0, host='127.0.0.1', rate=RATE)
        com.add_component(CameraServer(camera=painted))
        tell(url=stream.uri())
        sys.stdin.read()

# what shows it: each is a process that says where its page is ---------------------------------------------------------------------------

def panel(port, url):
    "Our panel, which finds the camera over MAVLink"
    from UAV.mavlink import CameraClient, MAVCom
    from UAV.manager import Gui
    with MAVCom(f'udpin:127.0.0.1:{port}', source_system=255) as com, Gui(com.add_component(CameraClient(190))) as gui:
        tell(page=gui.serve().url+'&jpeg')        # the panel's pictures, not a video
        sys.stdin.read()

def mjpeg(port, url, at_once=False):
    "A page with an `<img>` of multipart JPEGs, from the same Player and with the same quality; `at_once`: the boundary comes right behind each picture, not before the next one"
    import cv2
    from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
    from UAV.video.player import Player
    player = Player(url)
    class Handler(BaseHTTPRequestHandler):
        protocol_version,disable_nagle_algorithm = 'HTTP/1.1',True
        def log_message(self, *args): pass
        def do_GET(self):
            self.send_response(200)
            if self.path!='/stream': return self.answer(b'<!doctype html><title>MJPEG</title><link rel="icon" href="data:,"><img src="stream" width="640" height="480">')
            self.send_header('Content-Type', 'multipart/x-mixed-replace; boundary=next')
            self.end_headers()
            if at_once: self.wfile.write(b'--next\r\n')
            after = -1
            while frame := player.next(after):
                after = frame.number
                jpeg = cv2.imencode('.jpg', frame.image, [cv2.IMWRITE_JPEG_QUALITY,QUALITY])[1].tobytes()
                part = b'Content-Type: image/jpeg\r\nContent-Length: %d\r\n\r\n' % len(jpeg)+jpeg
                try: self.wfile.write(part+b'\r\n--next\r\n' if at_once else b'\r\n--next\r\n'+part)
                except OSError: return
        def answer(self, body):
            self.send_header('Content-Type', 'text/html')
            self.send_header('Content-Length', str(len(body)))
            self.end_headers()
            self.wfile.write(body)
    server = ThreadingHTTPServer(('127.0.0.1',0), Handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    tell(page=f'http://127.0.0.1:{server.server_port}/')
    sys.stdin.read()
    os._exit(0)

def raw(port, url):
    "No page: the pictures as our Player hands them out"
    from UAV.testing import read_mark
    from UAV.video.player import Player
    asked = threading.Thread(target=sys.stdin.read, daemon=True)
    with Player(url) as player:
        player.next(timeout=10)
        tell(page='')
        asked.start()
        seen = []
        for frame in player:
            found = read_mark(frame.image)
            if found: seen.append([*found, now_us()%BITS])
            if not asked.is_alive(): break
    tell(seen=seen)
    os._exit(0)

WORKERS = dict(camera=camera, panel=panel, mjpeg=mjpeg, raw=raw)

@contextmanager
def process(kind, **told):
    "A process of this script, and what it has told"
    line = [sys.executable, __file__, '--worker', json.dumps(dict(told, kind=kind))]
    worker = subprocess.Popen(line, env=dict(environment(), PYTHONPATH=environment()['UAV_TREE']), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    try:
        if not select.select([worker.stdout], [], [], 30)[0]: raise RuntimeError(f'{kind} does not start')
        yield SimpleNamespace(pid=worker.pid, worker=worker, **json.loads(worker.stdout.readline()))
    finally:
        worker.kill()
        worker.wait()
        for f in (worker.stdin, worker.stdout): f.close()

# the browser --------------------------------------------------------------------------------------------------------------------------

PROBE = '''
const canvas = document.createElement('canvas'), width = 128, height = 12      // 4×4 for each square of the mark
canvas.width = width; canvas.height = height
const context = canvas.getContext('2d', {willReadFrequently: true})
context.imageSmoothingEnabled = false
const probe = window.probe = {seen: [], on: true, last: ''}
const skew = Date.now()+.5-performance.timeOrigin-performance.now()
const offset = Math.abs(skew) > 2 ? skew : 0                                    // the clock of the system was set meanwhile
function look() {
  if (!probe.on) return
  const image = [...document.images].find(image => image.naturalWidth == arguments_size)
  if (image) {
    context.drawImage(image, 0, 0, image.naturalWidth, image.naturalWidth*3/32, 0, 0, width, height)
    const at = performance.timeOrigin+performance.now()+offset, pixels = context.getImageData(0, 0, width, height).data
    let text = ''
    for (let row = 0; row < 3; row++) for (let column = 0; column < 32; column++) text += pixels[4*((4*row+2)*width+4*column+2)+1] > 127 ? 1 : 0
    if (text != probe.last) probe.seen.push([probe.last = text, at])
  }
  requestAnimationFrame(look)
}
requestAnimationFrame(look)
'''.replace('arguments_size', str(SIZE[0]))

def read_bits(text):
    "`(number, time_us)` of the bits of a mark; `None` when its checksum is wrong"
    from UAV.testing.kit import _checksum
    painted = int(text, 2).to_bytes(12, 'big')
    body,checksum = painted[:10],painted[10:]
    return (int.from_bytes(body[:4], 'big'),int.from_bytes(body[4:], 'big')) if _checksum(body)==checksum else None

def cpu(*pids):
    "CPU seconds of these processes and of their children, user and system"
    alive = {p for pid in pids for p in [psutil.Process(pid), *psutil.Process(pid).children(recursive=True)]}
    return sum(sum(p.cpu_times()[:2]) for p in alive)

def judge(seen, seconds):
    "How late pictures were (ms), and how many a second"
    numbers = [n for n,*_ in seen]
    late = sorted(((at-then)%BITS)/1000 for _,then,at in seen)
    return dict(p50=short(statistics.median(late)), p95=short(late[int(.95*(len(late)-1)+.5)]), fps=short(len(set(numbers))/seconds), pictures=len(late),
                disordered=sum(b<a for a,b in zip(numbers, numbers[1:])))

def in_browser(shown, seconds):
    "What a browser sees on a page, and what server and browser need for that while we do not look"
    from tests.browser import Browser
    with Browser() as browser:
        page = browser.open(shown.page)
        page.js(PROBE)
        page.until('probe.seen.length > 10', timeout=30)
        time.sleep(2)                                           # all is warm
        page.js('probe.seen.length = 0')
        time.sleep(seconds)
        found = page.js('probe.on = false; return probe.seen')
        read = [(read_bits(text),int(at*1000)%BITS) for text,at in found]
        chromium = [p.pid for p in psutil.Process(browser.driver.service.process.pid).children()]
        before = cpu(shown.pid),cpu(*chromium)
        time.sleep(seconds)
        server,chrome = (100*(b-a)/seconds for a,b in zip(before, (cpu(shown.pid),cpu(*chromium))))
        complaints = browser.complaints()
    if complaints: print(shown.page.split('#')[0], complaints, file=sys.stderr)
    good = [(*mark,at) for mark,at in read if mark]
    return dict(judge(good, seconds), unreadable=len(read)-len(good), server=short(server), browser=short(chrome))

def without_browser(shown, seconds):
    "What our Player hands out, and what that needs"
    time.sleep(2)
    before = cpu(shown.pid)
    time.sleep(2*seconds)
    used = 100*(cpu(shown.pid)-before)/(2*seconds)
    shown.worker.stdin.close()
    seen = json.loads(shown.worker.stdout.readline())['seen']
    return dict(judge(seen[2*RATE:], 2*seconds), unreadable=0, server=short(used), browser=0)

CONTENDERS = {'panel': ('panel', {}, in_browser), 'MJPEG': ('mjpeg', {}, in_browser), 'MJPEG, boundary at once': ('mjpeg', dict(at_once=True), in_browser),
              'stream': ('raw', {}, without_browser)}

def measure(contender, port, url, seconds):
    kind,told,look = contender
    with process(kind, port=port, url=url, **told) as shown: return look(shown, seconds)

# all of it ----------------------------------------------------------------------------------------------------------------------------

def chromium_version():
    from tests.browser import find_chromium
    return subprocess.run([find_chromium()[0], '--version'], capture_output=True, text=True).stdout.split()[1]

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--quick', action='store_true', help='one short round: to see that it works, not to quote')
    parser.add_argument('--rounds', type=int, default=5)
    parser.add_argument('--seconds', type=float, default=10.)
    parser.add_argument('--only', choices=CONTENDERS, help='one of them; writes nothing without --out')
    parser.add_argument('--out', help='where the results go (panel.json)')
    parser.add_argument('--worker', type=json.loads, help=argparse.SUPPRESS)
    args = parser.parse_args()
    if told := args.worker: return WORKERS[told.pop('kind')](**told)
    rounds,seconds = (1,3.) if args.quick else (args.rounds,args.seconds)
    who = {name: c for name,c in CONTENDERS.items() if args.only in (None,name)}
    port,load = free_ports(),[os.getloadavg()[0]]
    with process('camera', port=port) as source:
        got = in_turn(who, rounds, lambda c: measure(c, port, source.url, seconds))
    load.append(os.getloadavg()[0])
    detail = {name: middle(found) for name,found in got.items()}
    for name,r in detail.items(): print(f'{name:24}', *(f'{k} {v:g}' for k,v in r.items()), sep='  ')
    if args.only and not args.out: return
    rows = [compare('panel', 'loopback', name, 'ms', got['panel'], got[name], target) for name,target in (('MJPEG',1.),('MJPEG, boundary at once',1.1))]
    for line in table(rows): print(line)
    write(args.out or HERE/'panel.json', dict(machine=dict(machine(), chromium=chromium_version()), quick=args.quick, size=SIZE, rate=RATE, seconds=seconds, rounds=rounds,
                                              load=load, target=60, rows=rows, detail=detail))

if __name__=='__main__': main()
