"""What a picture and a press cost the processor: `python benchmarks/pictures.py [--before TREE] [--quick] [--rounds 7]`.

* bare: a script that compresses an image with OpenCV and writes it as safely as we do (sync, then rename): the floor
* disk: a picture of our camera, served on a link: EXIF, log, notice and status on top of that
* quota 1000, quota 5000: the same on a card with a quota, and as many pictures on it
* press: a press on the panel's pad, from the browser's request to the gimbal's motor, both ends in one process

Each is measured in a process of its own, user and system time of all threads; the contenders take turns within each round.
The results go to benchmarks/pictures.json, which `explanations/performance` shows."""
import argparse, json, os, subprocess, sys, tempfile, time
from contextlib import ExitStack
from datetime import date
from pathlib import Path
from statistics import quantiles

from trees import HERE, TREE, environment

KINDS = 'bare','disk','quota 1000','quota 5000','press'
TIMES = {'bare': 300, 'disk': 200, 'quota 1000': 60, 'quota 5000': 30, 'press': 60}     # in one round
LONGEST = 60        # s for anything that is waited for


def each(act, times):
    "µs of the processor for one `act`, after some to warm up"
    for _ in range(max(times//10, 3)): act()
    begun = time.process_time()
    for _ in range(times): act()
    return (time.process_time()-begun)/times*1e6


def bare(times):
    "A picture of a plain script"
    import cv2, numpy as np
    image,numbers = np.zeros((48,64,3), np.uint8),iter(range(10**6))
    with tempfile.TemporaryDirectory() as folder:
        def shoot():
            path = Path(folder)/f'{next(numbers):06}.jpg'
            with open(f'{path}.part', 'wb') as file:
                file.write(cv2.imencode('.jpg', image, [cv2.IMWRITE_JPEG_QUALITY, 95])[1].tobytes())
                file.flush()
                os.fsync(file.fileno())
            os.replace(f'{path}.part', path)
        return each(shoot, times)


def picture(times, there=None):
    "A picture of our camera, with a server on a link; with a quota, and so many pictures `there`"
    from UAV.mavlink import CameraServer, MAVCom
    from ways import Dark
    with Dark() as camera, MAVCom('virtual:pictures', source_system=222) as vehicle, MAVCom('virtual:pictures', source_system=255):
        vehicle.add_component(CameraServer(camera=camera))
        jpeg = camera._encode(camera.read()) if there else b''
        for _ in range(there or 0): camera.storage.save(jpeg, time.time())
        camera.storage.quota = 1000. if there else None         # from here on; the folder would be listed for each of them
        def shoot():
            camera.image_start_capture()
            if not camera.wait_idle(LONGEST): raise TimeoutError('no picture')
        return each(shoot, times)


def press(times):
    "A press on the panel's pad; the release isn't counted"
    from ways import panel
    total = 0.
    with ExitStack() as parts:
        motor,act = panel(None, parts)
        for n in range(times):
            motor.moved.clear()
            begun = time.process_time()
            act('hold', pitch=5., yaw=10.+n, hold=f'h{n}', n=0)
            if not motor.moved.wait(LONGEST): raise TimeoutError('the motor was not told')
            total += time.process_time()-begun if n>=times//10 else 0.
            act('release', hold=f'h{n}')
    return total/(times-times//10)*1e6


def measured(kind, tree, times):
    "The µs of one kind, by a process that runs the code of `tree`"
    said = subprocess.run([sys.executable, __file__, '--one', kind, str(times)], env=environment(tree), capture_output=True, text=True, timeout=600)
    if said.returncode: raise RuntimeError(f'{kind} of {tree}: {said.stderr[-500:]}')
    return float(said.stdout.split()[-1])


def spread(values):
    "Median and quartiles"
    low,middle,high = quantiles(values, n=4) if len(values)>1 else values*3
    return [round(v, 3) for v in (middle, low, high)]


def commit(tree): return subprocess.run(['git', 'rev-parse', '--short', 'HEAD'], cwd=tree, capture_output=True, text=True).stdout.strip()


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument('--before', help='an older checkout')
    words.add_argument('--rounds', type=int, default=7)
    words.add_argument('--quick', action='store_true', help='one short round, to see that it works')
    words.add_argument('--one', nargs=2, help=argparse.SUPPRESS)
    given = words.parse_args()
    if given.one:
        kind,times = given.one[0],int(given.one[1])
        how = dict(bare=bare, press=press, disk=picture)
        print(how[kind](times) if kind in how else picture(times, int(kind.split()[1])), flush=True)
        os._exit(0)
    rounds,trees = 1 if given.quick else given.rounds,dict(now=TREE)|(dict(before=given.before) if given.before else {})
    rows = {kind: {name: [] for name in trees} for kind in KINDS}
    load = [os.getloadavg()[0]]
    for n in range(rounds):
        for kind in KINDS:
            for name in list(trees)[::1 if n%2 else -1]:
                if kind=='bare' and name!='now': continue
                rows[kind][name].append(measured(kind, trees[name], max(TIMES[kind]//(5 if given.quick else 1), 10)))
            print(n+1, kind, *(f'{name} {us[-1]:.0f} µs' for name,us in rows[kind].items() if us), flush=True)
    load.append(os.getloadavg()[0])
    found = {kind: {name: spread(us) for name,us in by.items() if us} for kind,by in rows.items()}
    floor = rows['bare']['now']
    for kind,by in rows.items():
        if by.get('before'): found[kind]['ratio'] = spread([now/before for now,before in zip(by['now'], by['before'])])
        if kind!='press': found[kind]['to bare'] = spread([now/one for now,one in zip(by['now'], floor)])
    machine = dict(date=f'{date.today():%d %B %Y}'.lstrip('0'), commit=commit(TREE), before=given.before and commit(given.before), cores=os.cpu_count())
    result = dict(quick=given.quick, rounds=rounds, machine=machine, load=load, rows=found)
    (HERE/'pictures.json').write_text(json.dumps(result, indent=1, ensure_ascii=False)+'\n')


if __name__=='__main__': main()
