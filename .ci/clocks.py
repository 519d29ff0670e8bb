#!/usr/bin/env python
"""What in test cells depends on real time: sleeps, upper bounds on elapsed time, and time-outs under three seconds, in notebooks that
ask for the real clock (`#| clock: real`). Prints how many there are. `--check` fails where a notebook has more than `clocks.json`
allows, and `--write` writes that file: a new test waits in simulated time, or has a limit that only a hang exceeds. `--all` counts
all notebooks, `--show` prints each place."""
import ast, json, re, sys
from pathlib import Path

here = Path(__file__).parent
root = here.parent
KINDS = 'sleeps','upper bounds','short time-outs'
CLOCKS = {'monotonic','time','perf_counter','monotonic_ns','time_ns','perf_counter_ns'}
LIMITS = 'timeout wait join until within read get recv result wait_for settimeout wait_idle'.split()


def read(source):
    "The syntax tree of a cell; a line of IPython's (`%…`, `!…`) becomes `pass`, unless all is Python"
    flags = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT|ast.PyCF_ONLY_AST
    try: return compile(source, 'cell', 'exec', flags)
    except SyntaxError: pass
    plain = (re.sub(r'\S.*', 'pass', line) if re.match(r'\s*[%!]', line) else line for line in source.split('\n'))
    return compile('\n'.join(plain), 'cell', 'exec', flags)


def cells(path):
    "The code cells of a notebook that are tests"
    for cell in json.loads(path.read_text(encoding='utf-8'))['cells']:
        source = ''.join(cell['source'])
        if cell['cell_type']!='code' or re.match(r'#\| (export|default_exp)', source): continue
        yield source


def name(node):
    "The last name of what is called"
    return getattr(node.func, 'attr', getattr(node.func, 'id', '')) if isinstance(node, ast.Call) else ''


def reads_clock(node): return any(name(n) in CLOCKS for n in ast.walk(node))
def number(node): return node.value if isinstance(node, ast.Constant) and type(node.value) in (int,float) else None


def is_upper_bound(node):
    "`clock() - began < 2`, in an assertion"
    if not isinstance(node, ast.Compare) or not isinstance(node.ops[-1], (ast.Lt,ast.LtE)): return False
    limit = number(node.comparators[-1])
    return limit is not None and limit<60 and any(isinstance(n, ast.BinOp) and isinstance(n.op, ast.Sub) and reads_clock(n) for n in ast.walk(node))


def found(source):
    "`(kind, line)` of each place in a cell"
    for node in ast.walk(read(source)):
        if name(node)=='sleep' and node.args and number(node.args[0])!=0: yield 'sleeps',node.lineno
        if isinstance(node, ast.Assert) and any(map(is_upper_bound, ast.walk(node))): yield 'upper bounds',node.lineno
        if not isinstance(node, ast.Call): continue
        given = [number(k.value) for k in node.keywords if k.arg in ('timeout','within')]
        given += [number(a) for a in node.args[-1:]] if name(node) in LIMITS else []
        if any(n is not None and 0<n<3 for n in given): yield 'short time-outs',node.lineno


def counts(every=False, show=False):
    "`{notebook: [sleeps, upper bounds, short time-outs]}`"
    notebooks = {}
    for path in sorted([*(root/'nbs').rglob('*.ipynb'), *(root/'tests').glob('*.ipynb')]):
        text = path.read_text(encoding='utf-8')
        if '.ipynb_checkpoints' in path.parts or not every and '"#| clock: real' not in text: continue
        places = []
        for source in cells(path):
            for kind,line in found(source):
                places.append(kind)
                if show: print(f'{path.relative_to(root)}: {kind}: {source.split(chr(10))[line-1].strip()}')
        if places: notebooks[str(path.relative_to(root))] = [places.count(kind) for kind in KINDS]
    return notebooks


if __name__ == '__main__':
    now = counts('--all' in sys.argv, '--show' in sys.argv)
    print(', '.join(f'{sum(n)} {kind}' for kind,n in zip(KINDS, zip(*now.values(), [0]*3))), f'in {len(now)} notebooks')
    if '--write' in sys.argv: (here/'clocks.json').write_text(json.dumps(now, indent=1)+'\n', encoding='utf-8')
    if '--check' not in sys.argv: sys.exit()
    allowed = json.loads((here/'clocks.json').read_text(encoding='utf-8'))
    more = [f'{n} has {c} of {", ".join(KINDS)}, and {allowed.get(n, [0]*3)} are allowed' for n,c in now.items()
            if any(a>b for a,b in zip(c, allowed.get(n, [0]*3)))]
    if more: sys.exit('\n'.join([*more, 'run these tests in simulated time, or give them limits that only a hang exceeds (.ci/clocks.py --show)']))
