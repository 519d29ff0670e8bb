"""Measure UAV beside pymavlink and MAVSDK, in one run on one machine, and compare. See README.md."""
import argparse, importlib.metadata, json, os, platform, select, socket, statistics, subprocess, sys, time
from datetime import date
from pathlib import Path

import psutil

HERE = Path(__file__).resolve().parent
CORES = sorted(os.sched_getaffinity(0)) if hasattr(os, 'sched_getaffinity') else []
WHERE = {'one core': CORES[:1], 'two cores': CORES[:2], 'not pinned': CORES} if len(CORES)>1 else {'one core': CORES}      # empty: this system cannot pin

class Gone(Exception): "A process of a contender has ended, or does not answer"

class Worker:
    "A process of contenders.py"
    def __init__(self, kind, **args):
        self.kind = kind
        self.process = subprocess.Popen([sys.executable, HERE/'contenders.py', kind, json.dumps(args)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        if self.hear(60)!='ready': raise Gone(kind)

    def hear(self, timeout):
        line = self.process.stdout.readline() if select.select([self.process.stdout], [], [], timeout)[0] else ''
        if line: return json.loads(line)
        self.close()
        raise Gone(f'{self.kind} did not answer')

    def tell(self, verb, **args):
        self.process.stdin.write(json.dumps([verb, args])+'\n')
        self.process.stdin.flush()
    def ask(self, verb, **args): self.tell(verb, **args); return self.hear(120)
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
    "The first of `n` UDP and TCP ports in a row that nobody uses"
    while True:
        first = [next(candidates) for _ in range(n)][0]
        socks = []
        try:
            for k in range(n):
                for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
                    socks.append(socket.socket(socket.AF_INET, kind))
                    socks[-1].bind(('127.0.0.1', first+k))
            return first
        except OSError: pass
        finally:
            for s in socks: s.close()

def median(values): return statistics.median(values)

def middle(rounds):
    "The median of each number over the rounds of one contender; lost commands are added up"
    return {k: sum(r[k] for r in rounds) if k=='lost' else round(median([r[k] for r in rounds]), 3) for k in rounds[0]}

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

# a command and its answer -------------------------------------------------------------------------------------------------------------

class Pair:
    "A client and its server, each a process; `both`: our client and server in one"
    def __init__(self, client, server=None, crowd=None, **how):
        links = how.get('links', 1)
        self.port,self.workers = free_ports(links),[]
        try:
            if server: self.workers.append(Worker(server, port=self.port, **how))
            if crowd: self.workers.append(Worker('crowd', port=self.port+(crowd['at']=='links'), **crowd))
            more = dict(server=True) if client=='uav_client' and not server else {}
            if client=='uav_client': more |= dict(component=how.get('components', 1), connection='tcp' if how.get('connection')=='tcpin' else 'udpout')
            self.workers.append(Worker(client, port=self.port, **more))
        except BaseException: self.close(); raise
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
    for p in pairs.values(): p.pin(where); p.run(n)
    return in_turn(pairs, rounds, lambda p: p.run(n))

def start(pairs):
    "`{name: Pair}` of those that can be started"
    found = {}
    for name,(args,how) in pairs.items():
        try: found[name] = Pair(*args, **how)
        except Gone as e: print(f'{name}: {e}', file=sys.stderr)
    return found

COMMANDS = {'UAV': ('uav_client','uav_server'), 'UAV, one process': ('uav_client',), 'pymavlink loop': ('loop_client','loop_server'),
            'pymavlink tight': ('tight_client','tight_server'), 'MAVSDK asyncio to UAV': ('mavsdk_asyncio','uav_server'),
            'MAVSDK asyncio to pymavlink tight': ('mavsdk_asyncio','tight_server'), 'MAVSDK blocking to pymavlink tight': ('mavsdk_blocking','tight_server'),
            'UAV to pymavlink tight': ('uav_client','tight_server'), 'pymavlink tight to UAV': ('tight_client','uav_server'),
            'hand-over alone': ('handover_client','handover_server')}

def command(quick):
    "COMMAND_LONG to COMMAND_ACK over UDP"
    rows,detail = [],{}
    pairs = start({name: (who,{}) for name,who in COMMANDS.items()})
    try:
        for where in WHERE:
            got = round_trips(pairs, 5 if quick else 25, 50 if quick else 200, where)
            detail[where] = {name: middle(r) for name,r in got.items()}
            sdk = min((n for n in got if n.startswith('MAVSDK asyncio')), key=lambda n: detail[where][n]['p50'], default=None)     # with the server that suits it best
            for name,ours,peer,theirs,target,stretch in () if where=='not pinned' else (        # which core each wakes on is luck: told, but no row
                    ('command, two processes', 'UAV', 'pymavlink loop', 'pymavlink loop', .8, .6),
                    ('command, two processes', 'UAV', 'MAVSDK asyncio', sdk, .4, .3),
                    ('command, one process', 'UAV, one process', 'pymavlink loop, two processes', 'pymavlink loop', 1., .7)):
                if theirs in got: rows.append(compare(name, where, peer, 'µs', got[ours], got[theirs], target, stretch))
    finally:
        for p in pairs.values(): p.close()
    return rows,detail

def compare(name, where, against, unit, ours, theirs, target, stretch=None, key='p50'):
    "A row of the table"
    a,b,r = middle(ours),middle(theirs),ratio(ours, theirs, key)
    more = dict(ours_p90=a['p90'], theirs_p90=b['p90']) if 'p90' in a else {}
    more |= dict(ours_cpu=a['cpu'], theirs_cpu=b['cpu']) if 'cpu' in a and key!='cpu' else {}
    more |= dict(lost=a['lost']+b['lost']) if 'lost' in a else {}
    return row(name, where, against, unit, a[key], b[key], r, target, stretch, **more)

def row(name, where, against, unit, ours, theirs, r, target, stretch=None, **more):
    return dict(name=name, where=where, against=against, unit=unit, ours=ours, theirs=theirs, **r, target=target, stretch=stretch, reached=r['ratio']<=target, **more)

# received messages --------------------------------------------------------------------------------------------------------------------

def message(quick):
    "What one message costs that arrives and nobody wants, and one that is delivered"
    with Worker('message') as w:
        w.pin(CORES[:1])
        rounds = [w.ask('run', turn=k%5) for k in range(4 if quick else 26)][1:]
    got = {name: [r[name] for r in rounds] for name in rounds[0]}
    rows = [compare(name, 'one core', f'pymavlink {theirs}', 'µs', got[ours], got[theirs], target, stretch)
            for name,ours,target,stretch in (('message nobody wants','feed_unwanted',1/8,1/12), ('message delivered','feed_wanted',1/2.5,1/4))
            for theirs in ('parse_char','recv_msg')]
    return rows,{name: middle(r) for name,r in got.items()}

def used(w, what):
    "What a process used in the time that `what` takes, per second"
    a,got = w.ask('facts'),w.ask('received')
    what()
    b,heard = w.ask('facts'),w.ask('received')
    s = b['at']-a['at']
    return dict(cpu=100*(b['cpu']-a['cpu'])/s, wakeups=(b['wakeups']-a['wakeups'])/s, **({} if heard is None else dict(received=(heard-got)/s)))

LISTENERS = {'UAV': 'uav_server', 'pymavlink recv_match': 'loop_server', 'MAVSDK, nothing subscribed': 'mavsdk_listener', 'recvfrom alone': 'receive_only'}

def link(quick):
    "A telemetry link of 2,000 messages a second, on which only commands are wanted"
    rounds,seconds = (2,1.) if quick else (8,4.)
    ports,workers = {name: free_ports() for name in LISTENERS},{}
    with Worker('sender', ports=list(ports.values())) as sender:
        try:
            for name,kind in LISTENERS.items():
                workers[name] = Worker(kind, port=ports[name])
                workers[name].pin(CORES[:1])
            sender.pin(CORES[-1:])
            wait_for_vehicle(workers['MAVSDK, nothing subscribed'])
            def load(name): return used(workers[name], lambda: sender.ask('send', port=ports[name], seconds=seconds))
            got = in_turn({n: n for n in workers}, rounds, load)
        finally:
            for w in workers.values(): w.close()
    rows = [compare('2,000 messages/s', 'one core', peer, '% CPU', got['UAV'], got[peer], target, stretch, key='cpu')
            for peer,target,stretch in (('pymavlink recv_match',.4,.3), ('MAVSDK, nothing subscribed',1.,None))]
    return rows,{name: middle(r) for name,r in got.items()}

def wait_for_vehicle(w):
    "Until MAVSDK has found the sender"
    until = time.monotonic()+20
    while not w.ask('vehicles'):
        if time.monotonic()>until: raise Gone('MAVSDK finds no vehicle')
        time.sleep(.1)

# many of them -------------------------------------------------------------------------------------------------------------------------

def components(quick):
    "Fifty components on one link: threads, and the round trip to the last of them"
    n = 50
    pairs = start({k: (('uav_client','uav_server'), dict(components=k)) for k in (1, n)})
    try:
        threads = psutil.Process(pairs[n].server.process.pid).num_threads()
        rows = [row('50 components', '', 'three threads', 'threads', threads, 3, dict(ratio=round(threads/3, 3)), 1.)]
        detail = dict(threads=threads)
        for where in list(WHERE)[:2]:
            got = round_trips(pairs, 5 if quick else 25, 50 if quick else 200, where)
            rows.append(compare('50 components', where, 'one component', 'µs', got[n], got[1], 1.1))      # as with one, and what the measurement is worth
            detail[where] = {str(k): middle(r) for k,r in got.items()}
    finally:
        for p in pairs.values(): p.close()
    return rows,detail

CONNECTIONS = {'peers': ('udpin, 100 peers','udpin'), 'clients': ('tcpin, 100 clients','tcpin'), 'links': ('100 udpin links','udpin')}

def connections(quick):
    "A server with a hundred connections: the round trip of one of them, the others beating"
    rows,detail,n = [],{},100
    for kind,(against,connection) in CONNECTIONS.items():
        how = dict(connection=connection)
        pairs = start({1: (('uav_client','uav_server'), how),
                       n: (('uav_client','uav_server'), dict(how, links=n if kind=='links' else 1, crowd=dict(n=n-1, at=kind)))})
        try:
            if n not in pairs: continue
            got = round_trips(pairs, 5 if quick else 15, 50 if quick else 200, list(WHERE)[:2][-1])
            rows.append(compare('100 connections', against, 'one connection', 'µs', got[n], got[1], 2.))
            detail[against] = {str(k): middle(r) for k,r in got.items()}
        finally:
            for p in pairs.values(): p.close()
    return rows,detail

# starting, and doing nothing ----------------------------------------------------------------------------------------------------------

def import_time(module):
    "Import `module` in a fresh process: ms"
    code = f'import time; t,c = time.perf_counter(),time.process_time(); import {module}; print(time.perf_counter()-t, time.process_time()-c)'
    env = dict(os.environ, MAVLINK20='1', PYTHONPATH=str(HERE.parent))
    wall,cpu = map(float, subprocess.run([sys.executable, '-c', code], env=env, capture_output=True, text=True, check=True).stdout.split())
    return dict(p50=1e3*wall, cpu=1e3*cpu)

def imports(quick):
    "How long an import takes"
    modules = 'UAV.mavlink','pymavlink.mavutil','pymavlink.dialects.v20.ardupilotmega','mavsdk'
    for m in modules: import_time(m)
    got = in_turn({m: m for m in modules}, 5 if quick else 25, import_time)
    return [compare('import', 'fresh process', 'pymavlink.mavutil', 'ms', got['UAV.mavlink'], got['pymavlink.mavutil'], 1.15, 1.)],{m: middle(r) for m,r in got.items()}

IDLE = {'UAV, 1 component': ('uav_server',dict(components=1)), 'UAV, 50 components': ('uav_server',dict(components=50)),
        'pymavlink recv_match': ('loop_server',{}), 'MAVSDK': ('mavsdk_listener',{})}

def idle(quick):
    "What it takes to hold still: one peer that beats, and nothing to do"
    ports,workers = {name: free_ports() for name in IDLE},{}
    with Worker('sender', ports=list(ports.values())):
        try:
            for name,(kind,how) in IDLE.items(): workers[name] = Worker(kind, port=ports[name], **how)
            wait_for_vehicle(workers['MAVSDK'])
            time.sleep(1 if quick else 10)            # MAVSDK asks a new vehicle a few things
            before = {name: w.ask('facts') for name,w in workers.items()}
            time.sleep(2 if quick else 30)
            detail = {}
            for name,w in workers.items():
                a,b,p = before[name],w.ask('facts'),psutil.Process(w.process.pid)
                s = b['at']-a['at']
                detail[name] = dict(threads=p.num_threads(), wakeups=round((b['wakeups']-a['wakeups'])/s, 1), cpu=round(100*(b['cpu']-a['cpu'])/s, 3), rss=round(p.memory_info().rss/2**20, 1))
        finally:
            for w in workers.values(): w.close()
    return [],detail

# all of it ----------------------------------------------------------------------------------------------------------------------------

GROUPS = dict(command=command, message=message, link=link, components=components, imports=imports, connections=connections, idle=idle)

def machine():
    "Where and when this was measured"
    cpu = next((l.split(':')[1].strip() for l in Path('/proc/cpuinfo').read_text().splitlines() if l.startswith('model name')), '') if Path('/proc/cpuinfo').exists() else ''
    versions = {p: importlib.metadata.version(p) for p in ('pymavlink','mavsdk','fastcrc') if any(d.metadata['Name']==p for d in importlib.metadata.distributions())}
    return dict(date=str(date.today()), cpu=cpu or platform.processor(), cores=len(CORES) or os.cpu_count(), system=platform.system(), python=platform.python_version(), **versions)

def write(path, what):
    "As JSON, a line for each entry and each row"
    def dump(x): return json.dumps(x, ensure_ascii=False)
    def block(x):
        if isinstance(x, dict): return '{\n'+',\n'.join(f'  {dump(k)}: {dump(v)}' for k,v in x.items())+'\n }'
        if isinstance(x, list) and x and isinstance(x[0], dict): return '[\n'+',\n'.join(f'  {dump(v)}' for v in x)+'\n ]'
        return dump(x)
    Path(path).write_text('{\n'+',\n'.join(f' {dump(k)}: {block(v)}' for k,v in what.items())+'\n}\n')

def table(rows):
    "The rows as text"
    for r in rows:
        spread = f'{r["low"]:.2f}–{r["high"]:.2f}' if 'low' in r else ''
        yield (f'{r["name"]:24}{r["where"]:20}{r["ours"]:9.2f} {r["theirs"]:9.2f} {r["unit"]:8}{r["ratio"]:6.2f} {spread:11} ≤ {r["target"]:.3g}'
               f'{"  reached" if r["reached"] else "  NOT":9}  {r["against"]}{" LOST "+str(r["lost"]) if r.get("lost") else ""}')

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--quick', action='store_true', help='few rounds: to see that it works, not to quote')
    parser.add_argument('--only', choices=GROUPS, help='one group; writes nothing without --out')
    parser.add_argument('--out', help=f'where the results go (results.json)')
    args = parser.parse_args()
    results = dict(machine=machine(), quick=args.quick, rows=[], detail={})
    for name,group in GROUPS.items():
        if args.only not in (None, name): continue
        print(f'{name}: {group.__doc__}', file=sys.stderr)
        rows,results['detail'][name] = group(args.quick)
        results['rows'] += rows
        for line in table(rows): print(line, flush=True)
    if args.only: print(json.dumps(results['detail'], indent=1, ensure_ascii=False))
    if args.out or not args.only: write(args.out or HERE/'results.json', results)

if __name__=='__main__': main()
