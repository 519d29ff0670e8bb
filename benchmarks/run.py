"""Measure UAV beside pymavlink, MAVSDK and an older checkout of itself, in one run on one machine. See README.md."""
import argparse, importlib.metadata, json, os, platform, re, select, shutil, socket, statistics, subprocess, sys, tempfile, time
from datetime import date
from pathlib import Path

import psutil
from trees import HERE, TREE, environment

CORES = sorted(os.sched_getaffinity(0)) if hasattr(os, 'sched_getaffinity') else []
WHERE = {'one core': CORES[:1], 'two cores': CORES[:2]} if len(CORES)>1 else {'one core': CORES}      # empty: this system cannot pin

class Gone(Exception): "A process of a contender has ended, or does not answer"

class Worker:
    "A process of contenders.py"
    script = HERE/'contenders.py'
    def __init__(self, kind, tree=None, **args):
        self.kind = kind
        self.process = subprocess.Popen([sys.executable, self.script, kind, json.dumps(args)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True, env=environment(tree))
        if self.hear(60)!='ready': raise Gone(kind)

    def hear(self, timeout):
        line = self.process.stdout.readline() if select.select([self.process.stdout], [], [], timeout)[0] else ''
        if line: return json.loads(line)
        self.close()
        raise Gone(f'{self.kind} did not answer')

    def tell(self, verb, **args):
        self.process.stdin.write(json.dumps([verb, args])+'\n')
        self.process.stdin.flush()

    def ask(self, verb, **args):
        self.tell(verb, **args)
        return self.hear(120)

    def pin(self, cores):
        for t in os.listdir(f'/proc/{self.process.pid}/task') if cores else (): os.sched_setaffinity(int(t), cores)

    def close(self):
        self.process.kill()
        self.process.wait()
        for f in (self.process.stdin, self.process.stdout): f.close()

    def __enter__(self): return self
    def __exit__(self, *args): self.close()

candidates = iter(range(20_000+os.getpid()%100*50, 32_000))     # below those that the system hands out

def free_ports(n=1):
    "The first of `n` UDP and TCP ports in a row that are not in use"
    while True:
        first,socks = [next(candidates) for _ in range(n)][0],[]
        try:
            for k in range(n):
                for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
                    socks.append(socket.socket(socket.AF_INET, kind))
                    socks[-1].bind(('127.0.0.1', first+k))
            return first
        except OSError: pass
        finally:
            for s in socks: s.close()

# rows and rounds ----------------------------------------------------------------------------------------------------------------------

def short(value):
    "Four digits say enough"
    return value if isinstance(value, int) else float(f'{value:.4g}')

def middle(rounds):
    "The median of each number over the rounds of one contender; lost commands are added up"
    return {k: sum(r[k] for r in rounds) if k=='lost' else short(statistics.median(r[k] for r in rounds)) for k in rounds[0]}

def ratio(ours, theirs, key='p50'):
    "How much of theirs ours is, round by round: median and quartiles"
    rs = sorted(a[key]/b[key] for a,b in zip(ours, theirs))
    q = statistics.quantiles(rs, n=4) if len(rs)>1 else rs*3
    return dict(ratio=round(q[1], 3), low=round(q[0], 3), high=round(q[2], 3))

def in_turn(contenders, rounds, measure):
    "`{name: [result of each round]}`; in each round all contenders in turn, each time another one first"
    names,found = list(contenders),{n: [] for n in contenders}
    for r in range(rounds):
        for n in names[r%len(names):]+names[:r%len(names)]: found[n].append(measure(contenders[n]))
    return found

def compare(name, where, against, unit, ours, theirs, target, stretch=None, key='p50', before=None, before_theirs=None):
    "A row of the table: the rounds of ours, of theirs, and of the tree before"
    a,b = middle(ours),middle(theirs)
    found = dict(name=name, where=where, against=against, unit=unit, ours=a[key], theirs=b[key], **ratio(ours, theirs, key), target=round(target, 3))
    if stretch: found['stretch'] = round(stretch, 3)
    if before:
        was = found['before'] = dict(ours=middle(before)[key], **ratio(before, before_theirs or theirs, key))
        found['change'] = round(found['ratio']/was['ratio'], 3) if before_theirs else ratio(ours, before, key)['ratio']     # each to its own peer, or in turns
    if lost := sum(middle(r).get('lost', 0) for r in (ours,theirs,before or theirs[:1])): found['lost'] = lost
    return dict(found, reached=found['ratio']<=found['target'])

def trees(before):
    "`{name: tree}` of what is measured; the one before has ' before' to its name"
    return {'': None, **({' before': before} if before else {})}

# a command and its answer -------------------------------------------------------------------------------------------------------------

class Pair:
    "A client and its server, each a process; without a server, our client and server in one"
    def __init__(self, client, server=None, crowd=None, tree=None, loop_reads=False, **how):
        self.port,self.workers = free_ports(how.get('links', 1)),[]
        try:
            if server: self.workers.append(Worker(server, tree=tree, port=self.port, **how))
            if crowd: self.workers.append(Worker('crowd', port=self.port+(crowd['at']=='links'), **crowd))
            more = dict(server=not server, loop_reads=loop_reads, component=how.get('components', 1)) if client=='uav_client' else {}
            if how.get('connection')=='tcpin': more['connection'] = 'tcp'
            self.workers.append(Worker(client, tree=tree, port=self.port, **more))
        except BaseException:
            self.close()
            raise
        self.client,self.server = self.workers[-1],self.workers[0]

    def pin(self, where):
        "Of two cores, the server gets the first, the client and the crowd get the other; one process has both"
        cores = WHERE[where]
        for w in self.workers: w.pin(cores if len(self.workers)==1 or where!='two cores' else cores[:1] if w is self.server else cores[-1:])

    def run(self, n):
        before = self.server.ask('facts')
        result = self.client.ask('run', n=n)
        if self.server is not self.client: result['cpu'] += 1e6*(self.server.ask('facts')['cpu']-before['cpu'])/n
        return result

    def close(self):
        for w in reversed(self.workers): w.close()

def round_trips(pairs, rounds, n, where):
    "Pin, warm up, measure: `{name: rounds}`"
    for p in pairs.values():
        p.pin(where)
        p.run(n)
    return in_turn(pairs, rounds, lambda p: p.run(n))

def start(pairs):
    "`{name: Pair}` of those that can be started"
    found = {}
    for name,(args,how) in pairs.items():
        try: found[name] = Pair(*args, **how)
        except Gone as e: print(f'{name}: {e}', file=sys.stderr)
    return found

THEIRS = {'pymavlink loop': ('loop_client','loop_server'), 'pymavlink tight': ('tight_client','tight_server'),
          'MAVSDK asyncio to UAV': ('mavsdk_asyncio','uav_server'), 'MAVSDK asyncio to pymavlink tight': ('mavsdk_asyncio','tight_server'),
          'MAVSDK blocking to pymavlink tight': ('mavsdk_blocking','tight_server'), 'hand-over alone': ('handover_client','handover_server')}
OURS = {'UAV': ('uav_client','uav_server'), 'UAV to pymavlink tight': ('uav_client','tight_server'), 'pymavlink tight to UAV': ('tight_client','uav_server'),
        'UAV, one process': ('uav_client',), 'UAV blocking': ('uav_blocking','uav_server')}

def command_pairs(before):
    "All that send a command: theirs, ours, ours before, and ours inside `async with` where a tree has that"
    pairs = {name: (who,{}) for name,who in THEIRS.items()}
    for label,tree in trees(before).items():
        has_loop = can_loop(tree)
        for name,who in OURS.items():
            pairs[name+label] = who,dict(tree=tree)
            if has_loop and who[0]=='uav_client': pairs[name+', async with'+label] = who,dict(tree=tree, loop_reads=True)
    return pairs

def can_loop(tree):
    "Has the tree an `async with MAVCom`?"
    code = 'from trees import TREE; from UAV.mavlink import MAVCom; raise SystemExit(not hasattr(MAVCom, "__aenter__"))'
    return subprocess.run([sys.executable, '-c', code], env=environment(tree), cwd=HERE).returncode==0

COMMAND_ROWS = (('command awaited', 'UAV', (1.4,1.1), (.7,.6)), ('command in async with', 'UAV, async with', (1.2,.8), (.55,.45)))

def command(quick, before):
    "COMMAND_LONG to COMMAND_ACK over UDP"
    rows,detail = [],{}
    pairs = start(command_pairs(before))
    try:
        for where in WHERE:
            got = round_trips(pairs, 5 if quick else 25, 50 if quick else 200, where)
            detail[where] = {name: middle(r) for name,r in got.items()}
            sdk = min((n for n in got if n.startswith('MAVSDK asyncio')), key=lambda n: detail[where][n]['p50'], default=None)     # with the server that suits it best
            def add(name, ours, theirs, target, stretch, peer=None, key='p50'):
                if ours in got and theirs in got:
                    rows.append(compare(name, where, peer or theirs, 'µs', got[ours], got[theirs], target, stretch, key, got.get(f'{ours} before')))
            for name,ours,loop,mavsdk in COMMAND_ROWS:
                add(name, ours, 'pymavlink loop', *loop)
                add(name, ours, sdk, *mavsdk, peer='MAVSDK asyncio')
            add('blocking command', 'UAV blocking', 'pymavlink loop', 1.2, 1.)
            add('blocking command', 'UAV blocking', 'MAVSDK blocking to pymavlink tight', 1.2, 1., peer='MAVSDK blocking')
            add('blocking command, processor', 'UAV blocking', 'pymavlink loop', 1.2, 1., key='cpu')
            add('both ends in one process', 'UAV, one process', 'pymavlink loop', {'one core':1.2}.get(where, 1.35), 1., peer='pymavlink loop, two processes')
    finally:
        for p in pairs.values(): p.close()
    return sorted(rows, key=lambda r: r['name']=='both ends in one process'),detail

# received messages --------------------------------------------------------------------------------------------------------------------

def message(quick, before):
    "What one message costs that arrives and is not wanted, and one that is delivered"
    with_each = {label: Worker('message', tree=tree) for label,tree in trees(before).items()}
    turn = iter(range(1000))
    try:
        for w in with_each.values():
            w.pin(CORES[:1])
            w.ask('run', turn=0)
        rounds = in_turn(with_each, 4 if quick else 25, lambda w: w.ask('run', turn=next(turn)%5))
    finally:
        for w in with_each.values(): w.close()
    got = {name+label: [r[name] for r in found] for label,found in rounds.items() for name in found[0]}
    rows = [compare(name, 'one core', 'pymavlink parse_char', 'µs', got[ours], got['parse_char'], target, stretch,
                    before=got.get(f'{ours} before'), before_theirs=got.get('parse_char before'))
            for name,ours,target,stretch in (('unwanted message','feed_unwanted',1/7,1/9), ('delivered message','feed_wanted',1/2.5,1/3))]
    return rows,{name: middle(r) for name,r in got.items() if name.startswith('feed') or not name.endswith('before')}

def used(w, what):
    "What a process used in the time that `what` takes, per second"
    a,got = w.ask('facts'),w.ask('received')
    what()
    b,heard = w.ask('facts'),w.ask('received')
    s = b['at']-a['at']
    return dict(cpu=100*(b['cpu']-a['cpu'])/s, wakeups=(b['wakeups']-a['wakeups'])/s, **({} if heard is None else dict(received=(heard-got)/s)))

LISTENERS = {'pymavlink recv_match': 'loop_server', 'MAVSDK, nothing subscribed': 'mavsdk_listener', 'recvfrom alone': 'receive_only'}

def link(quick, before):
    "A telemetry link of 2,000 messages a second, on which only commands are wanted"
    rounds,seconds = (2,1.) if quick else (8,4.)
    who = {**{name: (kind,None) for name,kind in LISTENERS.items()}, **{f'UAV{label}': ('uav_server',tree) for label,tree in trees(before).items()}}
    ports,workers = {name: free_ports() for name in who},{}
    with Worker('sender', ports=list(ports.values())) as sender:
        try:
            for name,(kind,tree) in who.items():
                workers[name] = Worker(kind, tree=tree, port=ports[name])
                workers[name].pin(CORES[:1])
            sender.pin(CORES[-1:])
            wait_for_vehicle(workers['MAVSDK, nothing subscribed'])
            def load(name): return used(workers[name], lambda: sender.ask('send', port=ports[name], seconds=seconds))
            got = in_turn({n: n for n in workers}, rounds, load)
        finally:
            for w in workers.values(): w.close()
    rows = [compare('2,000 messages/s', 'one core', peer, '% CPU', got['UAV'], got[peer], target, stretch, key='cpu', before=got.get('UAV before'))
            for peer,target,stretch in (('recvfrom alone',1.6,1.4), ('MAVSDK, nothing subscribed',1.,None))]
    return rows,{name: middle(r) for name,r in got.items()}

def wait_for_vehicle(w):
    "Until MAVSDK has found the sender"
    until = time.monotonic()+20
    while not w.ask('vehicles'):
        if time.monotonic()>until: raise Gone('MAVSDK finds no vehicle')
        time.sleep(.1)

# many of them -------------------------------------------------------------------------------------------------------------------------

COMPONENTS = (('50 components', 50, 'one component', 1, 1.1), ('200 components', 200, 'two components', 2, 1.05))

def components(quick, before):
    "Many components on one link: threads, and the round trip to the last of them"
    rows,detail = [],{}
    counts = sorted({n for _,many,_,few,_ in COMPONENTS for n in (many,few)})
    pairs = start({f'{n}{label}': (('uav_client','uav_server'), dict(components=n, tree=tree)) for n in counts for label,tree in trees(before).items()})
    try:
        for name,many,_,_,_ in COMPONENTS:
            threads = {label: [dict(p50=psutil.Process(pairs[f'{many}{label}'].server.process.pid).num_threads())] for label in trees(before)}
            rows.append(compare(name, '', 'three threads', 'threads', threads[''], [dict(p50=3)], 1., before=threads.get(' before')))
        for where in WHERE:
            got = round_trips(pairs, 5 if quick else 25, 50 if quick else 200, where)
            rows += [compare(name, where, peer, 'µs', got[f'{many}'], got[f'{few}'], target,         # as with few, and what the measurement is worth
                             before=got.get(f'{many} before'), before_theirs=got.get(f'{few} before')) for name,many,peer,few,target in COMPONENTS]
            detail[where] = {name: middle(r) for name,r in got.items()}
    finally:
        for p in pairs.values(): p.close()
    return sorted(rows, key=lambda r: r['name']!=COMPONENTS[0][0]),detail

CONNECTIONS = {'peers': ('udpin, 100 peers','udpin'), 'clients': ('tcpin, 100 clients','tcpin'), 'links': ('100 udpin links','udpin')}

def connections(quick, before):
    "A server with a hundred connections: the round trip of one of them, the others beating"
    rows,detail,n = [],{},100
    for kind,(what,connection) in CONNECTIONS.items():
        many = dict(links=n if kind=='links' else 1, crowd=dict(n=n-1, at=kind))
        who = {f'{k}{label}': (('uav_client','uav_server'), dict(how, connection=connection, tree=tree))
               for k,how in ((1,{}), (n,many)) for label,tree in trees(before).items()}
        pairs = start(who)
        try:
            if not {'1',f'{n}'}<=set(pairs): continue
            got = round_trips(pairs, 5 if quick else 15, 50 if quick else 200, list(WHERE)[-1])
            rows.append(compare('100 connections', what, 'one connection', 'µs', got[f'{n}'], got['1'], 2., before=got.get(f'{n} before'), before_theirs=got.get('1 before')))
            detail[what] = {name: middle(r) for name,r in got.items()}
        finally:
            for p in pairs.values(): p.close()
    return rows,detail

# starting, and doing nothing ----------------------------------------------------------------------------------------------------------

bytecode = tempfile.TemporaryDirectory()     # of all who are measured, ours and theirs

def as_installed(tree=None):
    "The environment of a program of a tree, compiled before as after an installation"
    env = dict(environment(tree), PYTHONPATH=str(tree or TREE), PYTHONPYCACHEPREFIX=bytecode.name)
    env.pop('PYTHONDONTWRITEBYTECODE', None)
    return env

def import_time(module, tree=None):
    "Import `module` in a fresh process, compiled before as after an installation: ms"
    code = f'import time; t,c = time.perf_counter(),time.process_time(); import {module}; print(time.perf_counter()-t, time.process_time()-c)'
    wall,cpu = map(float, subprocess.run([sys.executable, '-c', code], cwd=HERE, env=as_installed(tree), capture_output=True, text=True, check=True).stdout.split())
    return dict(p50=1e3*wall, cpu=1e3*cpu)

def imports(quick, before):
    "How long an import takes"
    modules = {m: (m,None) for m in ('pymavlink.mavutil','pymavlink.dialects.v20.ardupilotmega','mavsdk')}
    modules |= {f'UAV.mavlink{label}': ('UAV.mavlink',tree) for label,tree in trees(before).items()}
    for m in modules.values(): import_time(*m)
    got = in_turn(modules, 5 if quick else 25, lambda m: import_time(*m))
    row = compare('import', 'fresh process', 'pymavlink.mavutil', 'ms', got['UAV.mavlink'], got['pymavlink.mavutil'], 1., before=got.get('UAV.mavlink before'))
    return [row],{m: middle(r) for m,r in got.items()}

IDLE = {'UAV, 1 component': ('uav_server',dict(components=1)), 'UAV, 50 components': ('uav_server',dict(components=50)),
        'pymavlink recv_match': ('loop_server',{}), 'MAVSDK': ('mavsdk_listener',{})}

def idle(quick, before):
    "What it takes to hold still: one peer that beats, and nothing to do"
    who = {**IDLE, **({f'{name} before': (kind,dict(how, tree=before)) for name,(kind,how) in IDLE.items() if name.startswith('UAV')} if before else {})}
    ports,workers = {name: free_ports() for name in who},{}
    with Worker('sender', ports=list(ports.values())):
        try:
            for name,(kind,how) in who.items(): workers[name] = Worker(kind, port=ports[name], **how)
            wait_for_vehicle(workers['MAVSDK'])
            time.sleep(1 if quick else 10)            # MAVSDK asks a new vehicle a few things
            first = {name: w.ask('facts') for name,w in workers.items()}
            time.sleep(2 if quick else 30)
            detail = {name: held_still(w, first[name]) for name,w in workers.items()}
        finally:
            for w in workers.values(): w.close()
    return [],detail

def held_still(w, first):
    "What a process used since `first`, each second"
    now,p = w.ask('facts'),psutil.Process(w.process.pid)
    s = now['at']-first['at']
    return dict(threads=p.num_threads(), wakeups=round((now['wakeups']-first['wakeups'])/s, 1), cpu=round(100*(now['cpu']-first['cpu'])/s, 3), rss=round(p.memory_info().rss/2**20, 1))

# programs on a small computer ---------------------------------------------------------------------------------------------------------

START_ROWS = (('uav-camera','--help'), ('uav-camera','snap'), ('uav-gimbal','--help'), ('uav-camera-check','--help'), ('uav-camera-server','--help'),
              ('uav-gui','--help'), ('uav-demo','--help'))
START_PEERS = {'python': 'pass', 'pymavlink.mavutil': 'import pymavlink.mavutil', 'mavsdk': 'import mavsdk', 'mavsdk.asyncio': 'from mavsdk.asyncio import Mavsdk'}

def command_line(name, *words, tree=None):
    "What starts a program of a tree, installed or not; `None` if the tree has no such program"
    found = re.search(rf'(?<![\w-]){name}=([\w.]+):(\w+)', (Path(tree or TREE)/'settings.ini').read_text())
    if not found: return None
    code = f'import sys; sys.argv[0] = {name!r}; from {found[1]} import {found[2]} as main; sys.exit(main())'
    return [sys.executable, '-c', code, *words]

def processor_of(words, tree=None):
    "What a process takes of a processor from its start to its end, user and system, ms"
    process = subprocess.Popen(words, cwd=bytecode.name, env=as_installed(tree), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _,status,used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode: raise Gone(f'{words} ended with {process.returncode}')
    return dict(p50=1e3*(used.ru_utime+used.ru_stime))

class Program:
    "A running program of a tree, or a `Worker`, seen from outside: all of its threads"
    def __init__(self, *words, tree=None, worker=None):
        self.worker = worker
        self.process = worker.process if worker else subprocess.Popen(command_line(*words, tree=tree), cwd=tempfile.mkdtemp(dir=bytecode.name), env=as_installed(tree),
                                                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def facts(self):
        "Processor (s), wake-ups, threads and memory (MB) so far, and when"
        tasks,cpu,wakeups = list(Path(f'/proc/{self.process.pid}/task').iterdir()),0,0
        for t in tasks:
            cpu += int((t/'schedstat').read_text().split()[0])/1e9          # ns, where psutil counts in hundredths of a second
            wakeups += int(re.search(r'\nvoluntary_ctxt_switches:\s*(\d+)', (t/'status').read_text())[1])
        return dict(cpu=cpu, wakeups=wakeups, threads=len(tasks), rss=psutil.Process(self.process.pid).memory_info().rss/2**20, at=time.perf_counter())

    def close(self):
        if self.worker: return self.worker.close()
        self.process.terminate()
        self.process.wait(30)

def settle(programs):
    "Wait until all have started: each has a second thread, and uses less than a twentieth of a core for a second"
    until,last = time.monotonic()+120,[p.facts() for p in programs]
    while time.monotonic()<until:
        time.sleep(1)
        before,last = last,[p.facts() for p in programs]
        if all(b['threads']>1 and b['cpu']-a['cpu']<.05 for a,b in zip(before, last)): return
    raise Gone('a program does not start')

def starting(quick, before):
    "What a program takes of a processor from its start to its end, beside what the import of a library takes"
    servers = {label: (Program('uav-camera-server', '--rtsp', '-1', '--connection', f'udpin:127.0.0.1:{port}', tree=tree), port)
               for label,tree in trees(before).items() for port in [free_ports()]}
    words = dict(snap=lambda label: ['snap', '--connection', f'udpout:127.0.0.1:{servers[label][1]}'])
    who = {name: ([sys.executable, '-c', code],None) for name,code in START_PEERS.items()}
    if shutil.which('mavproxy.py'): who['mavproxy.py --help'] = ['mavproxy.py','--help'],None
    for label,tree in trees(before).items():
        for name,verb in START_ROWS:
            line = command_line(name, *words.get(verb, lambda label: [verb])(label), tree=tree)
            if line: who[f'{name} {verb}{label}'] = line,tree
    try:
        settle([server for server,_ in servers.values()])
        for w in who.values(): processor_of(*w)         # which compiles
        got = in_turn(who, 2 if quick else 15, lambda w: processor_of(*w))
    finally:
        for server,_ in servers.values(): server.close()
    rows = [compare('start', f'{name} {verb}', 'pymavlink.mavutil', 'ms', got[f'{name} {verb}'], got['pymavlink.mavutil'], 1.5, before=got.get(f'{name} {verb} before'))
            for name,verb in START_ROWS]
    return rows,{name: middle(r) for name,r in got.items()}

SERVED = {'uav-camera-server': ('--rtsp','0'), 'uav-camera-server --gimbal sim': ('--rtsp','0','--gimbal','sim'), 'uav-gui': ()}
STANDING = {'pymavlink heartbeats': 'heartbeat_camera', 'MAVSDK camera server': 'mavsdk_camera'}     # the peers

def waiting(quick, before):
    "A camera server that nobody watches, with a ground station that beats: what it takes of a core, and of memory"
    who = {**{name: (None,name.split()[0],words,None) for name,words in SERVED.items()}, **{name: (kind,None,(),None) for name,kind in STANDING.items()}}
    if before: who['uav-camera-server before'] = None,'uav-camera-server',SERVED['uav-camera-server'],before
    ports,programs = {name: free_ports() for name in who},{}
    def used(name):
        a,b = last[name],programs[name].facts()
        s,last[name] = b['at']-a['at'],b
        return dict(cpu=100*(b['cpu']-a['cpu'])/s, wakeups=(b['wakeups']-a['wakeups'])/s, threads=b['threads'], rss=b['rss'])
    with Worker('sender', ports=list(ports.values())):
        try:
            for wait in (0, 1 if quick else 60):        # the first time all is compiled, which takes memory; then all that is asked first is answered
                for p in programs.values(): p.close()
                for name,(kind,program,words,tree) in who.items():
                    link = '--connection', f'udpin:127.0.0.1:{ports[name]}'
                    programs[name] = Program(worker=Worker(kind, port=ports[name])) if kind else Program(program, *words, *link, tree=tree)
                settle(programs.values())
                time.sleep(wait)
            last,rounds = {name: p.facts() for name,p in programs.items()},[]
            for _ in range(2 if quick else 5):
                time.sleep(2 if quick else 12)
                rounds.append({name: used(name) for name in who})
        finally:
            for p in programs.values(): p.close()
    got = {name: [r[name] for r in rounds] for name in who}
    ours,was = got['uav-camera-server'],got.get('uav-camera-server before')
    def row(where, against, unit, key, theirs): return compare('camera server, idle', where, against, unit, ours, theirs, 1., key=key, before=was)
    rows = [row('processor', '0.5 % of a core', '% CPU', 'cpu', [dict(cpu=.5)]*len(ours)), row('memory', '60 MB', 'MB', 'rss', [dict(rss=60)]*len(ours)),
            row('processor', 'pymavlink heartbeats', '% CPU', 'cpu', got['pymavlink heartbeats']),
            row('memory', 'pymavlink heartbeats', 'MB', 'rss', got['pymavlink heartbeats'])]
    return rows,{name: middle(r) for name,r in got.items()}

# all of it ----------------------------------------------------------------------------------------------------------------------------

GROUPS = dict(command=command, message=message, link=link, components=components, imports=imports, connections=connections, idle=idle, starting=starting, waiting=waiting)

def commit(tree=None):
    "The commit of a tree, with + when files of the package differ from it; empty without git"
    def git(*args): return subprocess.run(['git', '-C', tree or TREE, *args], capture_output=True, text=True).stdout.strip()
    return git('rev-parse', '--short', 'HEAD')+('+' if git('status', '--porcelain', '--', 'UAV') else '')

def machine(before=None):
    "Where, when and which code was measured"
    info = Path('/proc/cpuinfo')
    cpu = next((l.split(':')[1].strip() for l in info.read_text().splitlines() if l.startswith('model name')), '') if info.exists() else ''
    versions = {p: importlib.metadata.version(p) for p in ('pymavlink','mavsdk','fastcrc') if any(d.metadata['Name']==p for d in importlib.metadata.distributions())}
    code = dict(commit=commit(), **(dict(before=commit(before)) if before else {}))
    return dict(date=str(date.today()), cpu=cpu or platform.processor(), cores=len(CORES) or os.cpu_count(), system=platform.system(), python=platform.python_version(), **versions, **code)

def write(path, what):
    "As JSON, a line for each entry and each row"
    def dump(x): return json.dumps(x, ensure_ascii=False)
    def block(x):
        if isinstance(x, dict): return '{\n'+',\n'.join(f'  {dump(k)}: {dump(v)}' for k,v in x.items())+'\n }'
        if isinstance(x, list) and x and isinstance(x[0], dict): return '[\n'+',\n'.join(f'  {dump(v)}' for v in x)+'\n ]'
        return dump(x)
    Path(path).write_text('{\n'+',\n'.join(f' {dump(k)}: {block(v)}' for k,v in what.items())+'\n}\n', encoding='utf-8')

def table(rows):
    "The rows as text"
    for r in rows:
        spread = f'{r["low"]:.2f}–{r["high"]:.2f}' if 'low' in r else ''
        was = f'{r["before"]["ratio"]:6.2f}' if 'before' in r else 6*' '
        changed = f'{r["change"]-1:+.0%}' if 'before' in r else ''       # of ours, to that before
        yield (f'{r["name"]:26}{r["where"]:20}{r["ours"]:9.2f} {r["theirs"]:9.2f} {r["unit"]:8}{was} →{r["ratio"]:6.2f} {spread:11}{changed:7} ≤ {r["target"]:<6.3g}'
               f'{"reached" if r["reached"] else "NOT":9}{r["against"]}{" LOST "+str(r["lost"]) if r.get("lost") else ""}')

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--before', type=Path, help='an older checkout, measured as well')
    parser.add_argument('--quick', action='store_true', help='few rounds: to see that it works, not to quote')
    parser.add_argument('--only', choices=GROUPS, help='one group; writes nothing without --out')
    parser.add_argument('--out', help='where the results go (results.json)')
    args = parser.parse_args()
    if args.before and not (args.before/'UAV').is_dir(): parser.error(f'{args.before} has no UAV')
    results = dict(machine=machine(args.before), quick=args.quick, rows=[], detail={})
    for name,group in GROUPS.items():
        if args.only not in (None, name): continue
        print(f'{name}: {group.__doc__}', file=sys.stderr)
        rows,results['detail'][name] = group(args.quick, args.before)
        results['rows'] += rows
        for line in table(rows): print(line, flush=True)
    worse = [f'{r["name"]}, {r["where"]} {r["change"]-1:+.0%}' for r in results['rows'] if r.get('change', 1)>1.1]
    if args.before: print('more than a tenth worse than before:', '; '.join(dict.fromkeys(worse)) or 'none')
    if args.only: print(json.dumps(results['detail'], indent=1, ensure_ascii=False))
    if args.out or not args.only: write(args.out or HERE/'results.json', results)

if __name__=='__main__': main()
