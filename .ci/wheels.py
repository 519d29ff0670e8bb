"""Build the sdist and the wheel, check them, and try the wheel: `python .ci/wheels.py [PYTHON …]`.

The wheel is built twice, from this checkout and from the sdist, in folders of other names and at other times; both must be the same to
the byte. Each PYTHON (`python3.10`, a path; this one when there is none) gets a fresh environment with the wheel alone, in which the demo
takes its pictures, each program prints its version, and the camera module is imported without a checkout. The last lines are a table."""
import hashlib, os, platform, subprocess, sys, tempfile, time
from pathlib import Path

top = Path(__file__).resolve().parents[1]
programs = 'uav-demo uav-camera-server uav-camera uav-gimbal uav-gui uav-camera-check'.split()
asked = "import platform, numpy, cv2, av; print(platform.python_version(), numpy.__version__, cv2.__version__, av.__version__)"


def run(*words, **how):
    "What a command prints; ends the script with all that it said when it fails"
    env = {k: v for k,v in os.environ.items() if k!='PYTHONPATH'} | how.pop('env', {})
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, env=env, **how)
    if done.returncode: sys.exit(f'{" ".join(map(str, words))}\n{done.stdout}{done.stderr}\nexit status {done.returncode}')
    return done.stdout.strip()


def environment(folder, python, *packages):
    "Its `bin`, with `packages` installed"
    run(python, '-m', 'venv', folder)
    here = Path(folder)/'bin'
    if packages: run(here/'pip', 'install', '-q', '--disable-pip-version-check', *packages)
    return here


def built(folder, tools):
    "The sdist, and the wheel made of it, with the time of the last commit in place of now"
    epoch = run('git', '-C', top, 'log', '-1', '--format=%ct')
    source = Path(folder)/'source'
    run('git', 'clone', '-q', top, source)
    run(tools/'python', '-m', 'build', '-o', Path(folder)/'dist', source, env=dict(SOURCE_DATE_EPOCH=epoch))
    return sorted((Path(folder)/'dist').iterdir())


def tried(python, wheel, folder):
    "One row of the table"
    began = time.monotonic()
    here = environment(folder, python, wheel)
    run(here/'uav-demo', '--out', 'pictures', cwd=folder)
    pictures = len(list((Path(folder)/'pictures').glob('IMG_*.jpg')))
    versions = {run(here/program, '--version', cwd=folder).split()[-1] for program in programs}
    if pictures!=5 or len(versions)!=1: sys.exit(f'{python}: {pictures} pictures, versions {versions}')
    python,numpy,opencv,av = run(here/'python', '-c', asked, cwd=folder).split()
    return f'| {python} | {platform.system()} {platform.machine()} | {numpy} | {opencv} | {av} | {pictures} pictures | {time.monotonic()-began:.0f} s |'


def main(*pythons):
    with tempfile.TemporaryDirectory() as work:
        tools = environment(f'{work}/tools', sys.executable, 'build', 'twine')
        first,second = built(f'{work}/first', tools),built(f'{work}/a second folder', tools)
        run(tools/'twine', 'check', '--strict', *first)
        for one,other in zip(first, second):
            same = one.read_bytes()==other.read_bytes()
            print(f'{one.name}: {one.stat().st_size/1e3:.0f} kB, sha256 {hashlib.sha256(one.read_bytes()).hexdigest()[:16]}…, twice the same: {same}')
            if not same and one.suffix=='.whl': sys.exit('the wheel is not reproducible')
        rows = [tried(python, first[1], f'{work}/try{n}') for n,python in enumerate(pythons or [sys.executable])]
        print('| Python | system | numpy | OpenCV | PyAV | demo | install and demo |\n|---|---|---|---|---|---|---|', *rows, sep='\n')


if __name__ == '__main__': main(*sys.argv[1:])
