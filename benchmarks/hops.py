"""What one `image_start_capture` takes, from the call to the return of its `await`, in this checkout and in an older one. See README.md."""
from collections import Counter
import argparse, asyncio, json, subprocess, sys, threading
from pathlib import Path

from trees import HERE, TREE, environment

OURS = str(TREE/'UAV')
WARM,MEASURED = 100,30

def is_ours(code): return code.co_filename.startswith(OURS)

# what is counted --------------------------------------------------------------------------------------------------------------------

class Count:
    "Everything that happens in all threads, while `on`"
    def __init__(self):
        self.clear(on=False)

    def clear(self, on):
        self.on,self.locked,self.hand_overs = on,0,0
        self.calls,self.lines,self.objects,self.threads = Counter(),Counter(),{},set()

    def profile(self, frame, event, arg):
        "For `sys.setprofile`: the calls of ours, whose methods they are, and what wakes another thread"
        if not self.on: return
        code = frame.f_code
        if event=='call' and is_ours(code):
            self.calls[code] += 1
            self.threads.add(threading.get_ident())
            if (owner := frame.f_locals.get('self')) is not None: self.objects[id(owner)] = owner
        came = event=='c_return' and is_ours(code) and arg.__name__.startswith('recv')           # a reader has woken
        self.hand_overs += came or event=='call' and code.co_name=='call_soon_threadsafe'       # or the event loop will

    def trace(self, frame, event, arg):
        "For `sys.settrace`: the lines of ours"
        if not is_ours(frame.f_code): return
        if self.on and event=='line': self.lines[frame.f_code.co_filename, frame.f_lineno] += 1
        return self.trace

class CountedLock:
    "A lock that counts how often it is taken"
    def __init__(self, lock, count): self._counted,self._count = lock,count
    def acquire(self, *args, **kwargs):
        self._count.locked += self._count.on
        return self._counted.acquire(*args, **kwargs)
    def __enter__(self): return self.acquire()
    def __exit__(self, *args): self._counted.release()
    def __getattr__(self, name): return getattr(self._counted, name)

def count_locks(count):
    "Have the locks counted that code of ours makes from now on, also those inside a Condition or an Event of its own"
    def counted(make):
        def lock():
            frame = sys._getframe(1)
            while frame and frame.f_code.co_filename==threading.__file__: frame = frame.f_back
            return CountedLock(make(), count) if frame and is_ours(frame.f_code) else make()
        return lock
    threading.Lock,threading.RLock = counted(threading.Lock),counted(threading.RLock)

# one of them, over UDP --------------------------------------------------------------------------------------------------------------

class Shutter:
    "The least that is a camera: what is counted is the asking"
    def __init__(self, information, status): self.information,self.status,self.count = information,status,0
    def image_start_capture(self, interval=0., count=1): self.count += count
    def capture_status(self): return self.status

def attributes(obj):
    "How many an object has of its own"
    slots = [n for c in type(obj).__mro__ for n in ([c.__slots__] if isinstance(getattr(c,'__slots__',()), str) else getattr(c,'__slots__',()))]
    return len(getattr(obj,'__dict__',()))+sum(hasattr(obj,n) for n in slots if not n.startswith('__'))

def our_class(obj):
    "The name of the class of ours that an object belongs to; empty when it is none of ours"
    return next((c.__name__ for c in type(obj).__mro__ if c.__module__.startswith('UAV.')), '')

def measure():
    "The counts of this tree"
    count = Count()
    count_locks(count)
    for module in (threading,sys):
        module.setprofile(count.profile)
        module.settrace(count.trace)
    from UAV.cameras import CameraInformation, CaptureStatus
    from UAV.logging import LogLevels
    from UAV.mavlink import CameraClient, CameraServer, MAVCom, mavlink
    class Calm(MAVCom): beat_period = 60.           # s; no heartbeat in between
    quiet,shutter,rounds = dict(loglevel=LogLevels.CRITICAL),Shutter(CameraInformation(model='Shutter'), CaptureStatus()),[]

    async def shoot(client):
        count.clear(on=True)
        ack = await client.image_start_capture()
        await asyncio.sleep(.05)                    # what the other threads have still to do for it
        count.on = False
        if not ack: raise SystemExit(f'{ack!r}')

    async def shoot_often(client):
        if not await client.wait_heartbeat(target_system=1, timeout=10): raise SystemExit('the server does not beat')
        for _ in range(WARM): await client.image_start_capture()
        for _ in range(MEASURED):
            await shoot(client)
            rounds.append(of_one(count))

    with Calm('udpin:127.0.0.1:0', source_system=1, **quiet) as server, Calm(f'udpout:127.0.0.1:{server.link.port}', source_system=255, **quiet) as ground:
        server.add_component(CameraServer(camera=shutter, **quiet))
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER, **quiet))
        client.set_target(1, mavlink.MAV_COMP_ID_CAMERA)
        asyncio.run(shoot_often(client))
    if shutter.count!=WARM+MEASURED: raise SystemExit(f'{shutter.count} pictures')
    return typical(rounds)

def of_one(count):
    "The numbers of one shot"
    functions = {(c.co_filename, c.co_firstlineno, c.co_name): c for c in count.calls}
    rooms = Counter(Path(c.co_filename).stem for c in count.calls.elements())
    owners = {name: attributes(o) for o in count.objects.values() if (name := our_class(o))}
    return dict(calls=sum(count.calls.values()), locks=count.locked, hand_overs=count.hand_overs, threads=len(count.threads), functions=len(functions),
                lines=len(count.lines), lines_run=sum(count.lines.values()), rooms=dict(rooms.most_common()), attributes=dict(sorted(owners.items(), key=lambda o: -o[1])),
                names=dict(Counter(f'{Path(c.co_filename).stem}.{c.co_qualname if hasattr(c,"co_qualname") else c.co_name}' for c in count.calls.elements()).most_common()))

def typical(rounds):
    "The round in the middle, by its calls"
    found = sorted(rounds, key=lambda r: r['calls'])[len(rounds)//2]
    return dict(found, spread=[min(r['calls'] for r in rounds), max(r['calls'] for r in rounds)])

# both -------------------------------------------------------------------------------------------------------------------------------

def of_tree(tree):
    ran = subprocess.run([sys.executable, __file__, '--here'], env=environment(tree), capture_output=True, text=True, timeout=300)
    if ran.returncode: raise SystemExit(ran.stderr[-3000:])
    return json.loads(ran.stdout.splitlines()[-1])

WORDS = dict(calls='calls of ours', locks='locks taken', hand_overs='hand-overs', threads='threads', functions='functions', lines='lines', lines_run='lines, each time they run')

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--before', type=Path, help='an older checkout, counted as well')
    parser.add_argument('--out', default=HERE/'hops.json')
    parser.add_argument('--names', action='store_true', help='also print the calls by name')
    parser.add_argument('--here', action='store_true', help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.here: return print(json.dumps(measure()))
    from run import machine, trees, write
    found = {label.strip() or 'now': of_tree(tree) for label,tree in trees(args.before).items()}
    print(f'{"":28}'+''.join(f'{name:>10}' for name in found))
    for key,words in WORDS.items(): print(f'{words:28}'+''.join(f'{f[key]:10}' for f in found.values()))
    for name,f in found.items(): print(name, 'rooms', f['rooms'], 'attributes', f['attributes'], 'spread', f['spread'])
    for name,f in found.items():
        names = f.pop('names')
        if args.names: print(name, *(f'{n:5} {what}' for what,n in names.items()), sep='\n')
    write(args.out, dict(machine=machine(args.before), **found))

if __name__=='__main__': main()
