#!/usr/bin/env python
"""Does a new test depend on real time? Counts, in notebooks that ask for the real clock (`#| clock: real`), sleeps, upper bounds on
elapsed time, and time-outs under three seconds. Where a notebook has more than `clocks.json` allows, its places are printed, and the
exit status is 1: a test waits in simulated time, or has a limit that only a hang exceeds. `--write` writes that file."""
import ast, json, re, sys
from pathlib import Path

from IPython.core.inputtransformer2 import TransformerManager

TOP = Path(__file__).parents[1]
ALLOWED = TOP/'.ci/clocks.json'
CLOCKS = {'monotonic','time','perf_counter','monotonic_ns','time_ns','perf_counter_ns'}
LIMITS = 'timeout wait join until within read get recv result wait_for settimeout wait_idle'.split()


def called(node): return getattr(node.func, 'attr', getattr(node.func, 'id', '')) if isinstance(node, ast.Call) else ''
def number(node): return node.value if isinstance(node, ast.Constant) and type(node.value) in (int,float) else None


def is_upper_bound(node):
    "`clock() - began < 2`"
    if not isinstance(node, ast.Compare) or not isinstance(node.ops[-1], (ast.Lt,ast.LtE)): return False
    spans = [n for n in ast.walk(node) if isinstance(n, ast.BinOp) and isinstance(n.op, ast.Sub)]
    return (number(node.comparators[-1]) or 60)<60 and any(called(n) in CLOCKS for span in spans for n in ast.walk(span))


def waits(node):
    "Does a node of a test depend on how fast the machine is?"
    if isinstance(node, ast.Assert): return any(map(is_upper_bound, ast.walk(node)))
    if not isinstance(node, ast.Call): return False
    if called(node)=='sleep': return bool(node.args) and number(node.args[0])!=0
    limits = [k.value for k in node.keywords if k.arg in ('timeout','within')]+(node.args[-1:] if called(node) in LIMITS else [])
    return any(0<(number(limit) or 0)<3 for limit in limits)


def places(notebook):
    "The lines of its tests that wait"
    for cell in json.loads(notebook.read_text(encoding='utf-8'))['cells']:
        if cell['cell_type']!='code' or re.match(r'#\| (export|default_exp)', ''.join(cell['source'])): continue
        source = TransformerManager().transform_cell(''.join(cell['source']))
        for node in ast.walk(compile(source, 'cell', 'exec', ast.PyCF_ALLOW_TOP_LEVEL_AWAIT|ast.PyCF_ONLY_AST)):
            if waits(node): yield source.split('\n')[node.lineno-1].strip()


if __name__ == '__main__':
    notebooks = sorted([*(TOP/'nbs').rglob('*.ipynb'), *(TOP/'tests').glob('*.ipynb')])
    found = {str(n.relative_to(TOP)): [*places(n)] for n in notebooks if '"#| clock: real' in n.read_text(encoding='utf-8')}
    if '--write' in sys.argv: ALLOWED.write_text(json.dumps({n: len(p) for n,p in found.items() if p}, indent=1)+'\n', encoding='utf-8')
    allowed = json.loads(ALLOWED.read_text(encoding='utf-8'))
    more = [f'{n}: {allowed.get(n, 0)} are allowed, not\n    '+'\n    '.join(p) for n,p in found.items() if len(p)>allowed.get(n, 0)]
    print(f'{sum(map(len, found.values()))} places depend on real time', *more, sep='\n')
    sys.exit(bool(more))
