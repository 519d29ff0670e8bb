"""How the package is laid out, before and after: `python benchmarks/house.py [REVISION …]` (default: fee2eaf HEAD).

Each revision is taken out of git into a folder of its own; nothing is installed. What imports cost is measured in fresh
processes of this Python, the revisions in turns, with the fastest run. `benchmarks/ways.py` counts what a picture, a
frame to a viewer and a press in the panel pass through. What cannot be measured is left out, with its reason. It takes a minute or two.
The results go to benchmarks/house.json, which `explanations/architecture` shows. `--minutes 8.1 14.5` are those of the README's
test command and of `.ci/run`, which you have measured; without it, those of the last time stay."""
import argparse, ast, json, os, subprocess, sys, tempfile
from collections import defaultdict
from pathlib import Path

top = Path(__file__).resolve().parents[1]
results = top/'benchmarks'/'house.json'
RUNS = 5            # of each import
LONGEST = 60        # s for one process
FAILURES = RuntimeError,ValueError,KeyError,subprocess.TimeoutExpired      # of one measurement, which is then left out
FUNCTIONS = ast.FunctionDef,ast.AsyncFunctionDef
MINUTES = "minutes of the README's test command, on two cores",'minutes of `.ci/run`'
BEFORE = {'fee2eaf': (2.4, 9.6)}        # measured on 29 November 2026
KEPT = 'f759dc7'    # the first revision: today's git doesn't have it, so its numbers stay as they were measured
BLOCKS = ast.If,ast.For,ast.While,ast.With,ast.Try,ast.ExceptHandler,*FUNCTIONS
PARAGRAPH = 40      # words of a cell that can give a reason


def lines(source): return sum(1 for line in source.split('\n') if line.strip() and not line.strip().startswith('#'))


def patched(function):
    "The class that a `@patch` function continues, or None"
    marks = {getattr(m, 'id', getattr(m, 'attr', '')) for m in (d.func if isinstance(d, ast.Call) else d for d in function.decorator_list)}
    first = (function.args.posonlyargs+function.args.args)[:1]
    return ast.unparse(first[0].annotation).strip('\'"') if 'patch' in marks and first and first[0].annotation else None


def members(node):
    "The names in the body of a class"
    for n in node.body:
        if isinstance(n, FUNCTIONS): yield n.name
        if isinstance(n, ast.AnnAssign): yield ast.unparse(n.target)
        if isinstance(n, ast.Assign): yield from (ast.unparse(t) for t in n.targets)


class Classes:
    "All classes of a revision: where they are written, and the names that they have"
    def __init__(self, trees):
        self.homes,self.named,self.bases,self.continued,self.public = defaultdict(set),defaultdict(set),{},defaultdict(set),0
        for path,tree in trees.items():
            for node in tree.body:
                if isinstance(node, ast.ClassDef): self.add(path, node)
        for path,tree in trees.items():
            for node in tree.body:
                owner = patched(node) if isinstance(node, FUNCTIONS) else None
                if owner:
                    self.named[owner].add(node.name)
                    if self.homes[owner] and path not in self.homes[owner]: self.continued[owner].add(path)
                elif isinstance(node, (*FUNCTIONS, ast.ClassDef)): self.public += not node.name.startswith('_')

    def add(self, path, node):
        self.homes[node.name].add(path)
        self.bases[node.name] = [ast.unparse(b).split('.')[-1] for b in node.bases]
        self.named[node.name].update(members(node))

    def names(self, of, seen=()):
        "Public names of a class, with all that it inherits"
        if of not in self.named or of in seen: return set()
        return {n for n in self.named[of] if n[0]!='_'} | {n for b in self.bases.get(of, []) for n in self.names(b, (*seen, of))}


def is_private(node):
    "Whether this takes `_name` of another object than `self`"
    if not isinstance(node, ast.Attribute) or node.attr[0]!='_' or node.attr[:2]=='__': return False
    owner = getattr(node.value, 'id', getattr(getattr(node.value, 'func', None), 'id', ''))
    return owner not in ('self','cls','super')


def is_packed(node):
    "A block on one line, or several names assigned at once"
    if isinstance(node, BLOCKS): return node.body[0].lineno==node.lineno
    return isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Tuple)


def density(trees):
    "What makes a module hard to read and to change, in numbers"
    nodes = [node for tree in trees.values() for node in ast.walk(tree)]
    called = [n for n in nodes if isinstance(n, ast.Call) and getattr(n.func, 'id', '') in ('hasattr','getattr') and len(n.args)>1]
    caught = [getattr(n.type, 'id', None) for n in nodes if isinstance(n, ast.ExceptHandler) and not isinstance(n.type, (ast.Tuple,ast.Attribute))]
    return {'functions': sum(isinstance(n, FUNCTIONS) for n in nodes), 'blocks and assignments packed into one line': sum(map(is_packed, nodes)),
            "uses of another object's `_name`": sum(map(is_private, nodes)),
            '`except` of all exceptions': sum(name in (None,'Exception','BaseException') for name in caught),
            '`hasattr` and `getattr` with a literal name': sum(isinstance(n.args[1], ast.Constant) for n in called)}


def reasons(folder):
    "How much the notebooks that export say in words"
    rooms = [json.loads(path.read_text()) for path in sorted((folder/'nbs').rglob('*.ipynb'))]
    rooms = [room['cells'] for room in rooms if any('#| default_exp' in ''.join(cell['source']) for cell in room['cells'])]
    words = [[len(''.join(cell['source']).split()) for cell in cells if cell['cell_type']=='markdown'] for cells in rooms]
    every = sorted(n for room in words for n in room)
    return {'words in the markdown cell in the middle': every[len(every)//2], f'% of markdown cells of {PARAGRAPH} words or more':
            round(100*sum(n>=PARAGRAPH for n in every)/len(every)), f'notebooks without a paragraph of {PARAGRAPH} words': sum(max(room)<PARAGRAPH for room in words)}


def parsed(folder):
    "`{path: syntax tree}` of the modules of a revision"
    paths = [p for p in sorted((folder/'UAV').rglob('*.py')) if p.name not in ('__init__.py','_modidx.py')]
    return {p.relative_to(folder): ast.parse(p.read_text()) for p in paths}


def layout(folder, trees):
    "What can be counted in the text of a revision"
    classes = Classes(trees)
    sizes = sorted(lines((folder/path).read_text()) for path in trees)
    stubs = subprocess.run(['git','ls-files','*.pyi'], cwd=folder, capture_output=True, text=True).stdout.split()
    widest = max((name for name in classes.bases if name[0]!='_'), key=lambda name: len(classes.names(name)))
    return {'modules': len(trees), 'lines in the module in the middle': sizes[len(sizes)//2], 'notebooks': len(list((folder/'nbs').rglob('*.ipynb'))),
            'exported lines': sum(sizes), 'classes in more than one module': len(classes.continued),
            'public functions and classes': classes.public, 'public names of `CameraClient`, with what it inherits': len(classes.names('CameraClient')),
            'public names of the class that has most': f'{len(classes.names(widest))} ({widest})',
            'lines of stubs in git': sum(len((folder/p).read_text().split('\n')) for p in stubs), **density(trees), **reasons(folder)}


CHANGES = {     # what a stranger changes, and the names that this is written in; a class counts with all modules that continue it
    'a command that the camera answers': ['CameraServer'], 'an answer to REQUEST_MESSAGE': ['CameraServer'], 'what every camera can do': ['Camera'],
    'a gimbal that `uav-camera-server --gimbal` names': ['make_gimbal','Viewsheen'], 'a type of setting': ['typed','param_type','definition_xml'],
    'a way to send video': ['TSSender','default_ports','stream_types'], 'a button for gimbals in the panel': ['GimbalRow',"'Turn the gimbal to its centre'"],
    'a verb of `uav-gimbal`': ['Steering','roi_none'], 'a requirement of the conformance suite': ['_beats'],
    'how soon a command is sent again': ['first_rto','least_rto','longest_back_off'], 'a tag in each picture': ['exif'],
    'the interval of heartbeats': ['MAVCom.beat_period'], 'how many files a peer may have open': ['FtpSessions.each']}


def given(node):
    "The names that a statement of a module gives, without those of classes"
    if isinstance(node, FUNCTIONS): return set() if patched(node) else {node.name}
    targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign) else []
    return {ast.unparse(name) for target in targets for name in getattr(target, 'elts', [target])}


def writes(node, name):
    "Whether a statement of a module is of the class `name`, or gives this name or `_name`, or `Class.name`"
    owner,_,member = name.partition('.')
    if isinstance(node, ast.ClassDef): return node.name==owner and (not member or member in str([*members(node)]))
    return bool({name, f'_{name}'} & given(node)) or isinstance(node, FUNCTIONS) and patched(node)==owner and member in ('', node.name)


def files_of(folder, trees, names):
    "The modules in which these names are written; a name in quotes is searched in all text"
    found = {str(path) for path,tree in trees.items() if any(writes(node, name) for node in tree.body for name in names if name[0]!="'")}
    texts = [name.strip("'") for name in names if name[0]=="'"]
    files = (p for p in (folder/'UAV').rglob('*') if p.suffix in ('.py','.js'))
    return sorted(found | {str(p.relative_to(folder)) for p in files if any(text in p.read_text() for text in texts)})


def run(folder, *args):
    "What a fresh Python prints with the package of `folder`"
    env = {**os.environ, 'PYTHONPATH': str(folder), 'PYTHONWARNINGS': 'ignore', 'MAVLINK20': '1'}
    ran = subprocess.run([sys.executable, *args], cwd=folder, env=env, capture_output=True, text=True, timeout=LONGEST)
    if ran.returncode: raise RuntimeError(ran.stderr.strip().split('\n')[-1])
    return ran.stdout.strip().split('\n')[-1]


LOADED = '''
import time, sys
began = time.perf_counter()
{0}
took = time.perf_counter()-began
print(sum(name.split('.')[0]=='UAV' for name in sys.modules), took)
'''
IMPORTS = {'`import UAV.mavlink`': 'import UAV.mavlink', '`from UAV.mavlink import MAVCom`, both servers and both clients':
           'from UAV.mavlink import MAVCom, CameraClient, CameraServer, GimbalClient, GimbalServer', '`import pymavlink.mavutil`': 'import pymavlink.mavutil'}


def imports(folders):
    "What imports cost, the revisions in turns; seconds are those of the fastest run"
    seconds,modules = {},{}
    for _ in range(RUNS):
        for name,folder in folders.items():
            for what,code in IMPORTS.items():
                try: count,took = run(folder, '-c', LOADED.format(code)).split()
                except FAILURES as e: print(f'not measured: {what}: {e}', file=sys.stderr)
                else: modules[name,what],seconds[name,what] = int(count),min(seconds.get((name,what), float(took)), float(took))
    return {name: {**{f'modules of ours that {what} loads': modules[name,what] for what in IMPORTS if (name,what) in modules and 'pymavlink' not in what},
                   **{f'seconds of {what}': round(seconds[name,what], 3) for what in IMPORTS if (name,what) in seconds}} for name in folders}


WAYS = dict(image='one `image_start_capture`, from the datagram to the idle camera', frame="a frame to a viewer of RTSP", press="a press in the panel, to the gimbal's motor")


def ways(folder):
    "Calls, modules and changes of module for three things"
    for way,what in WAYS.items():
        try: found = json.loads(run(folder, str(top/'benchmarks'/'ways.py'), way))[way]
        except FAILURES as e: print(f'not measured: {what}: {e}', file=sys.stderr)
        else: yield f'calls / modules / changes of module for {what}',' / '.join(map(str, found))


def taken_out(revision, within):
    "A folder with the files of a revision, and the revision's name"
    def git(*args): return subprocess.run(['git','-C',str(top),*args], check=True, capture_output=True, text=True).stdout.strip()
    name = git('rev-parse', '--short=7', revision)
    folder = Path(within)/name
    subprocess.run(['git','clone','-q','--shared','--no-checkout',str(top),str(folder)], check=True)
    subprocess.run(['git','-C',str(folder),'checkout','-q',name], check=True)
    return name,folder


def minutes(revision, told, last):
    "Of the tests: those that were told, or those of the last time"
    known = BEFORE.get(revision) or told or [last.get(what) for what in MINUTES]
    return {what: n for what,n in zip(MINUTES, known) if n is not None}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('revisions', nargs='*', default=['fee2eaf','HEAD'])
    parser.add_argument('--minutes', nargs=2, type=float, metavar=('TESTS','CI'))
    args = parser.parse_args()
    last = json.loads(results.read_text())
    old,known = last[KEPT],last['changes']
    newest = [numbers for name,numbers in last.items() if name!='changes'][-1]
    with tempfile.TemporaryDirectory() as temporary:
        folders = dict(taken_out(revision, temporary) for revision in args.revisions)
        trees = {name: parsed(folder) for name,folder in folders.items()}
        found,costs = {name: layout(folder, trees[name]) for name,folder in folders.items()},imports(folders)
        for name,folder in folders.items(): found[name].update({**costs[name], **dict(ways(folder)), **minutes(name, args.minutes, newest)})
        changes = {what: {'names': names, KEPT: known[what][KEPT], **{name: files_of(folder, trees[name], names) for name,folder in folders.items()}}
                   for what,names in CHANGES.items()}
    found = {KEPT: old, **found}
    for what in dict.fromkeys(what for numbers in found.values() for what in numbers): print(f'{what:95}', *(f'{f.get(what, "")!s:>18}' for f in found.values()))
    for what,files in changes.items(): print(f'files for {what:85}', *(f'{len(files[name]):>18}' for name in found))
    results.write_text(json.dumps(dict(found, changes=changes), indent=1)+'\n')


if __name__=='__main__': main()
