#!/usr/bin/env python
"""`nbdev-test` with a process of its own for each notebook, so that one that hangs, crashes, or leaves threads and log levels
behind fails alone. It takes nbdev-test's options, and `--path NOTEBOOK`. Nothing is tried twice.

A notebook runs in simulated time (`UAV.testing.simulated`), where its verdict doesn't depend on the machine, unless it has a line
`#| clock: real, REASON`. `--real` gives all of them the real clock, `--seed N` another order of their threads. One that begins worlds
itself has a line `#| core: one`. As root on Linux a notebook has a network of its own, unless it has a browser or a line
`#| network: real, REASON`.

The first group is what runs without options: it needs nothing but the dev environment. `--rest` runs the second group: notebooks
with a line `#| tests: all` and cells that begin with `#| slow`, `#| gst`, `#| browser`, … where these are installed. `--all` runs both.
The last lines are how many passed, failed and were skipped, and why."""
import ctypes, faulthandler, fcntl, gc, importlib, os, pkgutil, re, resource, signal, socket, struct, sys, threading, time
from multiprocessing import get_context
from multiprocessing.connection import wait
from pathlib import Path

os.environ['OPENBLAS_NUM_THREADS'] = '1'       # its threads would begin with the imports below, before the forks
os.environ.pop('PYTHONDONTWRITEBYTECODE', None)     # or each program that a test starts would compile the package anew
import nbdev.test
from installed import NEEDS,in_browser,installed
import av, cv2, hypothesis, matplotlib.pyplot, numpy, PIL.Image, pymavlink.dialects.v20.all, UAV  # noqa: F401  once here, and not in each process
sys.path.insert(0, str(Path(__file__).parents[1]))
from UAV.testing import simulated

LONGEST = 1200                          # s for one notebook; then it says where it hangs, and ends
BROWSERS = 2                            # notebooks with a browser at a time
WORKERS = 2*(os.cpu_count() or 1)       # for half of its time a notebook waits; more make each one late, and all no faster
CORES = sorted(os.sched_getaffinity(0)) if hasattr(os, 'sched_getaffinity') else []
LONG = '''panel_in_jupyterlab panel_in_a_browser panel_settings panel_under_siege devices_conformance camera_conformance
    programs 01_plugin hostile_bytes 03_camera examples 04_gimbal 06_check 16_check_a_camera
    watch_in_qgroundcontrol_vlc_ffplay 07_files run_on_a_companion_computer 05_gui 02_serve hostile_files
    killed_while_capturing stray_acks 11_survey_by_distance serial_and_mavproxy 02_payload several_cameras_on_one_vehicle
    03_receivers panel_map watch_in_a_browser'''.split()      # they need longest
PASSED,FAILED = 60,61           # what `child` ends with; a notebook that ends its process itself, with 0 perhaps, has not passed
GROUP,FLAGS,SEED = '',[],0      # from the command line: '', --rest or --all; cells to run; a seed of `None` is the real clock
NETWORK = False                 # each notebook can have a network of its own
results = {}                    # notebook: whether it passed, its seconds, and those of the processor


def mark_of(notebook, mark):
    "What stands behind a mark such as `#| clock: real` in a notebook; `None` without one"
    found = re.search(rf'"#\| {mark}\b,? ?(.*?)(?:\\n)?"', notebook.read_text(encoding='utf-8'))
    return found and found[1]


def simulates(notebook): return SEED is not None and mark_of(notebook, 'clock: real') is None


def isolates(notebook):
    "Whether a notebook has a network of its own; with only a loopback, Chromium is offline"
    return NETWORK and not in_browser(notebook) and mark_of(notebook, 'network: real') is None


def load():
    "Import all of the package, once and not in each process"
    for module in pkgutil.walk_packages(UAV.__path__, 'UAV.'):
        try: importlib.import_module(module.name)
        except ImportError as e: print(f'{module.name}: {e}', flush=True)
    hypothesis.settings.register_profile('same', derandomize=True, database=None, deadline=None,
                                         suppress_health_check=[hypothesis.HealthCheck.too_slow])
    hypothesis.settings.load_profile('same')        # the same examples each time, however busy the machine is
    hypothesis.given(hypothesis.strategies.integers())(lambda number: None)()       # it reads all modules for their constants
    gc.freeze()             # what is loaded now is not looked through again by each process


def processor():
    "Seconds of the processor that this process and those that it has waited for took"
    return sum(r.ru_utime+r.ru_stime for r in map(resource.getrusage, (resource.RUSAGE_SELF,resource.RUSAGE_CHILDREN)))


def own_network():
    "Give this process a network of its own with only a loopback: its ports are free, whatever runs beside it. Linux, as root"
    unshare = getattr(ctypes.CDLL(None), 'unshare', None)
    if not unshare or unshare(0x40000000): return               # CLONE_NEWNET of sched.h
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
        up = struct.pack('16sh22x', b'lo', 0x1|0x40|0x1000)     # IFF_UP, IFF_RUNNING and IFF_MULTICAST of if.h
        fcntl.ioctl(s, 0x8914, up)                              # SIOCSIFFLAGS


def has_own_network():
    "Whether `own_network` works here: tried in a child, since there's no way back"
    if pid := os.fork(): return os.waitpid(pid, 0)[1] == 0
    try:
        own_network()
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
            s.settimeout(60)
            s.bind(('127.0.0.1', 0))
            s.sendto(b'heard', s.getsockname())
            os._exit(s.recv(9) != b'heard')
    finally: os._exit(1)


def child(test, notebook, options, core, used):
    "Test one notebook in this process, and leave with `PASSED` or `FAILED`; threads it left are not waited for"
    os.setpgid(0, 0)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    faulthandler.dump_traceback_later(LONGEST, exit=True)
    if core is not None: os.sched_setaffinity(0, [core])
    if isolates(notebook):
        os.environ['UAV_MACHINE_NETWORK'] = f'/proc/{os.getppid()}/ns/net'      # for pip: see `tests/programs.ipynb`
        own_network()
    if simulates(notebook): simulated(SEED).__enter__()         # it ends with the process
    passed,_ = test(notebook, **options)
    used.value = processor()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(PASSED if passed else FAILED)


def core_for(notebook, busy):
    "The core with the fewest notebooks of simulated time: where one thread runs at a time, a change of cores costs a quarter of it"
    if not CORES or not simulates(notebook) and mark_of(notebook, 'core: one') is None: return
    taken = [core for *_,core in busy.values()]
    return min(CORES, key=taken.count)


def start(test, notebook, options, core):
    "The process that tests `notebook`, when it was started, its seconds of the processor, and its core"
    fork = get_context('fork')
    used = fork.Value('d', 0.)
    process = fork.Process(target=child, args=(test, notebook, options, core, used))
    process.start()
    return process,notebook,time.time(),used,core


def end(process):
    "Kill `process`, if it runs, and all that it has started"
    try: os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError: process.kill()


def finish(process, notebook, began, used, core):
    "Whether `notebook` passed, its seconds, and those of the processor; its processes end with it"
    process.join()
    end(process)
    ended = process.exitcode
    if ended not in (PASSED, FAILED): print(f'{notebook.name}: its process ended with {ended}', file=sys.stderr, flush=True)
    return ended == PASSED,time.time()-began,used.value


def run(test, waiting, workers, options):
    "What `finish` says of each notebook of `waiting`, `workers` at a time, `BROWSERS` with a browser among them at most"
    busy = {}
    try:
        while waiting or busy:
            while len(busy) < workers:
                full = sum(in_browser(notebook) for _,notebook,*_ in busy.values()) >= BROWSERS
                ready = next((notebook for notebook in waiting if not (full and in_browser(notebook))), None)
                if ready is None: break
                waiting.remove(ready)
                started = start(test, ready, options, core_for(ready, busy))
                busy[started[0].sentinel] = started
            for sentinel in wait(list(busy)):
                started = busy.pop(sentinel)
                results[started[1]] = finish(*started)
    finally:
        for process,*_ in busy.values(): end(process)


def order(notebook):
    "Few of a browser run at a time, so they begin first; then those that are known to be long, then by the size of their code"
    rank = LONG.index(notebook.stem) if notebook.stem in LONG else len(LONG)
    code = re.findall(r'"cell_type": "code".*?"source": \[(.*?)\]', notebook.read_text(encoding='utf-8'), re.S)
    return not in_browser(notebook),rank,-sum(map(len, code))


def parallel(test, notebooks, n_workers, pause, **options):
    "fastcore's `parallel`, as nbdev-test calls it: what `test` gives for each notebook, in their order"
    run(test, sorted(notebooks, key=order), max(WORKERS, n_workers), options)
    return [results[notebook][:2] for notebook in notebooks]


def is_second(notebook): return mark_of(notebook, 'tests: all') is not None
def has_cells(notebook): return any(mark_of(notebook, flag) is not None for flag in FLAGS)


def notebooks(path=None, **options):
    "nbdev's `nbglob`; without a path the notebooks of `tests/` too, and of all these our group"
    if path: return nbglob(path, **options)
    found = [*nbglob(path, **options), *sorted((Path(__file__).parents[1]/'tests').glob('*.ipynb'))]
    if GROUP=='--all': return found
    return [notebook for notebook in found if (is_second(notebook) or has_cells(notebook) if GROUP else not is_second(notebook))]


def report(flags, began, used):
    "Print how long it took, how many passed and failed, and which cells were not run"
    failed = sorted(notebook.stem for notebook,(passed,*_) in results.items() if not passed)
    slow = sorted(results, key=lambda notebook: -results[notebook][1])[:10]
    seconds,used = time.time()-began,processor()-used
    print('The longest:', '; '.join(f'{notebook.stem} {results[notebook][1]:.0f} s, {results[notebook][2]:.0f} of processor' for notebook in slow))
    print(f'{seconds/60:.1f} minutes, {used/60:.1f} of processor; the load is {os.getloadavg()[1]:.1f}')
    real = sorted((notebook.stem, mark_of(notebook, 'clock: real') or '') for notebook in results if not simulates(notebook))
    if SEED is not None: print(f'{len(results)-len(real)} in simulated time, {len(real)} in real time:', '; '.join(f'{name} ({why})' for name,why in real))
    for flag in ('notest', 'slow', 'hardware', *NEEDS):
        marked = [re.findall(rf'"#\| {flag}\b', notebook.read_text(encoding='utf-8')) for notebook in results]
        if flag not in flags and any(marked): print(f'skipped: {sum(map(len, marked))} cells that begin with `#| {flag}`, of {sum(map(bool, marked))} notebooks')
    if failed: print('failed:', *failed)
    print(f'{len(results)-len(failed)} notebooks passed, {len(failed)} failed', flush=True)


def option(name, default=None, value=False):
    "Take an option of ours off the command line: true if it stands there, or its value"
    if name not in sys.argv: return default
    at = sys.argv.index(name)
    return sys.argv.pop(at) and (sys.argv.pop(at) if value else True)


if __name__ == '__main__':
    signal.signal(signal.SIGTERM, lambda *_: sys.exit('ended from outside'))      # so that `run` ends its processes
    if path := option('--path', value=True): sys.argv.insert(1, path)
    GROUP = option('--rest') and '--rest' or option('--all') and '--all' or ''
    SEED = None if option('--real') else option('--seed', 0, value=True)
    load()
    assert threading.active_count() == len(os.listdir('/proc/self/task') if sys.platform == 'linux' else [0]) == 1, 'a fork needs one thread'
    NETWORK = has_own_network()
    nbdev.test.parallel,nbglob,nbdev.test.nbglob = parallel,nbdev.test.nbglob,notebooks
    if '--flags' not in sys.argv: sys.argv += ['--flags', ' '.join(['slow', *installed()] if GROUP or path else [])]
    FLAGS,began,used = sys.argv[sys.argv.index('--flags')+1].split(),time.time(),processor()
    try: nbdev.test.nbdev_test()
    finally: report(FLAGS, began, used)
    sys.exit(not results)       # a path that does not exist is not a success
