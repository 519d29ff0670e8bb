"""Write a stub (`.pyi`) beside each module, so that an editor sees in a class what `@patch` adds to it, and what each parameter is.

setup.py calls `write` when the wheel or the editable install is built; `python _stubs.py` does it at any time. The comments of
parameters are in the stubs' docstrings, for editors; `explain` puts them into those of the wheel's modules as well, for `help`."""
import ast, builtins, copy, re
from pathlib import Path

KEPT = ('property', 'cached_property', 'classmethod', 'staticmethod', 'setter', 'contextmanager', 'asynccontextmanager',
        'dataclass')
EXPLAINED = 'mavlink', 'cameras', 'gimbals', 'manager', 'wire', 'blocking'      # what people call; a program's docstrings are its help
COMMENT = re.compile(r"""(?:[^#'"]|'[^']*'|"[^"]*")*#\s*(.*)""")      # what follows a parameter in its line
CLASSES = {}        # those of the package, by name
METHODS = {}        # their methods, by `CLASS.NAME`
HEAD = '''# Made by _stubs.py when the package was installed.
from typing import Any, AsyncIterator, ClassVar, Iterator
from typing_extensions import Self
'''


def is_public(name): return not name.startswith('_') or name.endswith('__')


def name_of(node):
    "The last name of a decorator, a base, or a called function"
    node = node.func if isinstance(node, ast.Call) else node
    return getattr(node, 'attr', getattr(node, 'id', ''))


def is_function(node): return isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))


def top_of(body):
    "The statements of a module, and those within its `if`, `try` and `with`"
    for node in body:
        yield node
        if isinstance(node, (ast.If, ast.Try, ast.With)): yield from top_of(node.body)


def inside(function):
    "All nodes of a function, without those of functions within it"
    waiting = list(function.body)
    while waiting:
        yield (node := waiting.pop())
        if not is_function(node): waiting += ast.iter_child_nodes(node)


def named(text): return ast.Name(text)


def expression(text): return ast.parse(text).body[0].value


def optional(kind):
    "`kind`, or `None`"
    text = ast.unparse(kind)
    return kind if 'None' in text or 'Any' in text else expression(f'{text} | None')


def parsed(text):
    "The syntax tree of a module, in which parameters and fields have their comment as `says`"
    tree,lines = ast.parse(text),text.encode().splitlines()
    last = {n.lineno: n for n in ast.walk(tree) if isinstance(n, (ast.arg, ast.AnnAssign))}    # of several in a line
    for node in last.values():
        comment = COMMENT.match(lines[node.end_lineno-1][node.end_col_offset:].decode())
        if comment: node.says = comment[1]
    return tree


def told(node):
    "`(name, comment)` of the parameters of a function, with its options, or of the fields of a dataclass"
    if isinstance(node, ast.ClassDef):
        fields = node.body if 'dataclass' in map(name_of, node.decorator_list) else []
        given = [(n.target.id, n) for n in fields if isinstance(n, ast.AnnAssign)]
    else:
        args = node.args
        every = [*args.posonlyargs, *args.args, args.vararg, *args.kwonlyargs, args.kwarg]
        given = [(a.arg, a) for a in every if a and a.lineno < node.body[0].lineno]
        options = [(name, n) for name,_,n in options_of(node)]
        given = [one for one in given if not options or one[1] is not args.kwarg]+options
    return [(name, n.says) for name,n in given if hasattr(n, 'says') and name != 'self']


def documentation(node):
    "The docstring of a function or class, and what its parameters or fields are; empty when it has neither"
    doc,says = ast.get_docstring(node) or '',told(node)
    title = '\n\nFields:' if isinstance(node, ast.ClassDef) else '\n\nParameters:'
    return '\n'.join([doc+title, *(f'    {name}: {what}' for name,what in says)]) if says else doc


def explained(text):
    "A module's text, in which `help` shows the parameters of what is public and the fields of its dataclasses"
    tree,lines = parsed(text),text.encode().splitlines(keepends=True)
    kinds = ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef
    nodes = [n for n in ast.walk(tree) if isinstance(n, kinds) and is_public(n.name) and told(n)]
    for node in sorted(nodes, key=lambda n: n.body[0].lineno, reverse=True):
        doc,first = repr(documentation(node)).encode(),node.body[0]
        before,there = lines[first.lineno-1][:first.col_offset],lines[first.lineno-1][first.col_offset:]
        if ast.get_docstring(node): lines[first.lineno-1:first.end_lineno] = [before, doc, lines[first.end_lineno-1][first.end_col_offset:]]
        elif node.name == '__init__': lines[first.lineno-1] = before+doc+(b'; ' if before.strip() else b'\n'+before)+there
    return b''.join(lines).decode()


def patched(function):
    "The classes that a `@patch` function belongs to, or nothing"
    first = (function.args.posonlyargs+function.args.args)[:1]
    if 'patch' not in map(name_of, function.decorator_list) or not first: return []
    return [name_of(n) for n in ast.walk(first[0].annotation) if isinstance(n, (ast.Name, ast.Attribute))]


def decorators(function):
    "Those that a type checker knows; what `@patch` makes of a function is among them"
    found = [d for d in function.decorator_list if name_of(d) in KEPT]
    made = dict(as_prop='property', set_prop=f'{function.name}.setter', cls_method='classmethod')
    marks = [mark for mark in function.decorator_list if name_of(mark) == 'patch' and isinstance(mark, ast.Call)]
    return found+[named(made[word.arg]) for mark in marks for word in mark.keywords]


def parses(annotation):
    "Does an option of a program name a function that parses it, in place of a type?"
    modules = {id(n.value) for n in ast.walk(annotation) if isinstance(n, ast.Attribute)}
    names = [n.id for n in ast.walk(annotation) if isinstance(n, ast.Name) and id(n) not in modules]
    return any(name.islower() and name not in vars(builtins) for name in names)


def typed(args, is_method):
    "Parameters of which each has a type; a default is left when it is short"
    positional = args.posonlyargs+args.args
    pairs = list(zip(positional[len(positional)-len(args.defaults):], args.defaults))+list(zip(args.kwonlyargs, args.kw_defaults))
    for a in [*positional[is_method:], *args.kwonlyargs, args.vararg, args.kwarg]:
        if a and (a.annotation is None or parses(a.annotation)): a.annotation = named('Any')
    for a,default in pairs:
        if isinstance(default, ast.Constant) and default.value is None: a.annotation = optional(a.annotation)
        if isinstance(default, ast.Tuple) and ast.unparse(a.annotation) == 'list': a.annotation = expression('list | tuple')
    args.defaults = [d if isinstance(d, ast.Constant) else ast.Constant(...) for d in args.defaults]
    args.kw_defaults = [d if d is None or isinstance(d, ast.Constant) else ast.Constant(...) for d in args.kw_defaults]
    if is_method: positional[0].annotation = None


def returned(function):
    "What a call gives: as it is annotated, or what is certain"
    nodes,kind = list(inside(function)),function.returns
    values = [ast.unparse(n.value) for n in nodes if isinstance(n, ast.Return) and n.value]
    if any(isinstance(n, (ast.Yield, ast.YieldFrom)) for n in nodes):
        name = 'AsyncIterator' if isinstance(function, ast.AsyncFunctionDef) else 'Iterator'
        return expression(f'{name}[{ast.unparse(kind) if kind else "Any"}]')
    if kind and ast.unparse(kind) == 'bytes | Path': return named('Any')        # which one depends on an argument
    if kind or values: return kind or named('Self' if set(values) == {'self'} else 'Any')
    is_hook = isinstance(function.body[-1], (ast.Raise, ast.Pass)) or all(isinstance(n, (ast.Expr, ast.Constant)) for n in nodes)
    return named('Any') if is_hook and function.name != '__init__' else ast.Constant(None)


def with_target(made):
    "A verb as `@verb` makes it: a method that sends, behind its target"
    free = len(made.args.args)-1-len(made.args.defaults)           # these have no default in the source
    made.args.defaults = [ast.Constant(None)]*2+[ast.Constant(...)]*free+made.args.defaults
    made.args.args[1:1] = [ast.arg(name, expression('int | None')) for name in ('target_system', 'target_component')]
    return ast.AsyncFunctionDef(**{**vars(made), 'returns': named('Ack')})


def target_verb(name, call):
    "A verb as `TargetVerb(COMMAND, CLASS.VERB, PART, PUBLISHED='NAME')` makes it: that verb, behind a target"
    made,published = stub_of(METHODS[ast.unparse(call.args[1])], True),{k.value.value: k.arg for k in call.keywords}
    for a in made.args.args: a.arg = published.get(a.arg, a.arg)
    doc = ast.get_docstring(made, clean=False) or ''
    for old,new in published.items(): doc = doc.replace(f'\n    {old}: ', f'\n    {new}: ')
    made.name,made.body = name,[ast.Expr(ast.Constant(doc or ...))]
    return with_target(made)


def options_of(function):
    "`(name, type, node)` of what `**kwargs` of a function takes, by its mark `@delegates(CLASS)` or `@takes_options(CLASS)`"
    for mark in function.decorator_list:
        if name_of(mark) not in ('delegates', 'takes_options') or not getattr(mark, 'args', None): continue
        name = ast.unparse(mark.args[0]).removesuffix('.__init__').split('.')[-1]
        body = CLASSES[name].body if name in CLASSES else []
        yield from ((n.target.id, n.annotation, n) for n in body if isinstance(n, ast.AnnAssign))
        for n in filter(is_function, body):
            if n.name == '__init__': yield from ((a.arg, a.annotation, a) for a in n.args.args[len(n.args.args)-len(n.args.defaults):])


def spelled_out(made):
    "A function with its options in place of `**kwargs`"
    there = {a.arg for a in made.args.args+made.args.kwonlyargs}
    options = [ast.arg(name, kind) for name,kind,_ in options_of(made) if name not in there]
    if not options: return
    made.args.kwonlyargs += options
    made.args.kw_defaults += [ast.Constant(...)]*len(options)
    made.args.kwarg = None


def stub_of(function, is_method=False):
    "A function without its body"
    made = copy.deepcopy(function)
    spelled_out(made)
    made.returns,made.decorator_list = returned(made),decorators(made)
    if 'Iterator[' in ast.unparse(made.returns): made = ast.FunctionDef(**vars(made))          # nothing to await
    typed(made.args, is_method and not any(name_of(d) == 'staticmethod' for d in made.decorator_list))
    if is_method and any(name_of(d) == 'verb' for d in function.decorator_list): made = with_target(made)
    made.body = [ast.Expr(ast.Constant(documentation(function) or ...))]
    return made


def names_in(node):
    "The names that an assignment gives to"
    nodes = [n for target in getattr(node, 'targets', ()) for n in ast.walk(target)]
    return [n.id for n in nodes if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)]


def pairs_of(node):
    "`(target, value)` of an assignment; no value where it cannot be seen"
    for target in getattr(node, 'targets', None) or [node.target]:
        if not isinstance(target, ast.Tuple): yield target,node.value
        elif isinstance(node.value, ast.Tuple): yield from zip(target.elts, node.value.elts)
        else: yield from ((one, None) for one in target.elts)


def attributes(functions):
    "`{name: type}` of what the methods of a class assign to `self`: a parameter's type where that is all"
    found = {}
    for function in functions:
        typed(args := copy.deepcopy(function.args), True)
        kinds = {a.arg: a.annotation for a in args.args[1:]+args.kwonlyargs}
        if any(isinstance(n, ast.Call) and name_of(n) == 'store_attr' for n in inside(function)): found.update(kinds)
        nodes = [n for n in inside(function) if isinstance(n, (ast.Assign, ast.AugAssign, ast.AnnAssign))]
        for to,value in [pair for node in nodes for pair in pairs_of(node)]:
            if not isinstance(to, ast.Attribute) or ast.unparse(to.value) != 'self': continue
            kind = kinds.get(value.id) if isinstance(value, ast.Name) else None
            found[to.attr] = kind if kind and to.attr not in found else named('Any')
    return found


def annotated(name, kind, default=None): return ast.AnnAssign(ast.Name(name, ast.Store()), kind, default, 1)


def plain(node):
    "An assignment in a module or class: its names, and no values but that of `__all__`"
    if isinstance(node, ast.AnnAssign):
        by_name = isinstance(node.value, ast.Call) and any(k.arg=='kw_only' for k in node.value.keywords)
        default = node.value if by_name else node.value and ast.Constant(...)
        return [annotated(node.target.id, node.annotation, default)]
    if '__all__' in names_in(node): return [node]
    if isinstance(node.value, ast.Name) and node.value.id in CLASSES and isinstance(node.targets[0], ast.Name): return [node]  # a class, too
    if isinstance(node.value, ast.Call) and name_of(node.value) == 'property': return [getter(name) for name in names_in(node)]
    constant = isinstance(node.value, ast.Constant) and node.value.value not in (None, ...)
    return [annotated(name, named(type(node.value.value).__name__ if constant else 'Any')) for name in names_in(node)]


def getter(name): return ast.parse(f'@property\ndef {name}(self) -> Any: ...').body[0]


def parts_of(node):
    "`{name: type}` of the parts that a class of `KeepsNames` gives its objects"
    tables = [n.value for n in node.body if isinstance(n, ast.Assign) and names_in(n) == ['_parts'] and isinstance(n.value, ast.Call)]
    return {k.arg: k.value for table in tables for k in table.keywords if isinstance(k.value, ast.Name) and k.value.id in CLASSES}


def inherited_parts(node):
    "The names of the parts of the classes that a class continues"
    bases = [CLASSES[name_of(b)] for b in node.bases if name_of(b) in CLASSES]
    return {name for base in bases for name in {*parts_of(base)} | inherited_parts(base)}


def class_stub(node, patches):
    "A class with all that `@patch` adds to it"
    marks = {name_of(mark) for mark in [*node.decorator_list, *node.bases]}
    has_fields,is_enum = marks & {'dataclass', 'NamedTuple'},any(mark.endswith(('Enum', 'Flag')) for mark in marks)
    every = [*filter(is_function, node.body), *patches]
    functions = [f for f in every if is_public(f.name)]
    doc = documentation(node)
    body = [ast.Expr(ast.Constant(doc))] if doc else []
    for n in node.body:
        if is_enum and isinstance(n, ast.Assign): body.append(n)
        elif isinstance(n, ast.Assign) and isinstance(n.value, ast.Call) and name_of(n.value) == 'TargetVerb':
            body.append(target_verb(n.targets[0].id, n.value))
        elif isinstance(n, ast.Assign) and has_fields: body += [annotated(name, named('ClassVar[Any]')) for name in names_in(n)]
        elif isinstance(n, (ast.Assign, ast.AnnAssign)): body += plain(n)
    there = {f.name for f in filter(is_function, [*functions, *body])} | {n.target.id for n in body if isinstance(n, ast.AnnAssign)}
    there |= inherited_parts(node)
    for name,kind in {**attributes(every), **parts_of(node)}.items():      # what is annotated in a dataclass is a field
        if is_public(name) and name not in there: body.append(annotated(name, kind))
    body += [stub_of(f, True) for f in functions]
    bases,kept = [b for b in node.bases if name_of(b) != 'GetAttr'],[d for d in node.decorator_list if name_of(d) in KEPT]
    return ast.ClassDef(node.name, bases, node.keywords, body or [ast.Expr(ast.Constant(...))], kept)


def imported(node):
    "`(name, statements)` of each name that an import gives; who reads a stub finds only what is called as it was"
    for a in node.names:
        name = a.asname or a.name
        if not isinstance(node, ast.ImportFrom): yield name, [ast.Import([a])]
        elif a.name.startswith('_') or node.module == '__future__': continue
        elif name == '*': yield f'* of {node.module}', [node]
        elif name == a.name: yield name, [ast.ImportFrom(node.module, [ast.alias(name, name)], node.level)]
        else:
            hidden = ast.ImportFrom(node.module, [ast.alias(a.name, f'_{name}')], node.level)
            yield name, [hidden, ast.Assign([ast.Name(name, ast.Store())], named(f'_{name}'))]


def given(node, patches):
    "`(name, statements)` of each name that a statement of a module gives"
    if isinstance(node, (ast.Import, ast.ImportFrom)): yield from imported(node)
    elif isinstance(node, (ast.Assign, ast.AnnAssign)):
        for made in plain(node): yield ast.unparse(getattr(made, 'target', None) or made.targets[0]), [made]
    elif isinstance(node, ast.ClassDef): yield node.name, [class_stub(node, patches.get(node.name, []))]
    elif is_function(node) and not patched(node) and not node.name.startswith('__'): yield node.name, [stub_of(node)]


def is_hidden(node):
    "Is it a private name that nobody needs to read a stub?"
    if isinstance(node, ast.AnnAssign): return not is_public(node.target.id)
    return is_function(node) and not is_public(node.name)


def offered(nodes):
    "The names in `__all__`; of a door those of its `_rooms`, `{module: names}`"
    values = {name: node.value for node in nodes if isinstance(node, ast.Assign) for name in names_in(node)}
    return {*rooms_of(nodes)} | ({*ast.literal_eval(values['__all__'])} if isinstance(values['__all__'], ast.List) else set())


def rooms_of(nodes):
    "What a door loads when it is asked for: `{name: module}`"
    rooms = [n.value for n in nodes if isinstance(n, ast.Assign) and names_in(n) == ['_rooms']]
    return {name: module for value in rooms for module,names in ast.literal_eval(value).items() for name in names.split()}


def stub(tree, homes):
    "The stub of a module; `homes`: where each class of the package is defined"
    nodes,patches = list(top_of(tree.body)),{}
    for node in filter(is_function, nodes):
        for name in patched(node): patches.setdefault(name, []).append(node)
    found = {name: made for node in nodes for name,made in given(node, patches)}       # what comes last counts
    module = ast.Module([one for made in found.values() for one in made if not is_hidden(one)], [])
    used = {n.id for n in ast.walk(module) if isinstance(n, ast.Name)}
    if '__all__' in found: used |= offered(nodes)      # a door may import some when asked
    where = {**homes, **rooms_of(nodes)}
    elsewhere = [f'from {where[name]} import {name} as {name}' for name in sorted(used & {*where}-{*found}) if name != 'mavutil']
    if 'mavutil' in rooms_of(nodes): elsewhere.append('from pymavlink import mavutil as mavutil')
    if rooms_of(nodes): module.body = [one for one in module.body if '__all__' not in names_in(one)]+ast.parse(f'__all__ = {sorted(offered(nodes))}').body
    return HEAD+'\n'.join([*elsewhere, ast.unparse(ast.fix_missing_locations(module))])+'\n'


class Plain(ast.NodeTransformer):
    "A handle's class for a program without `async`: what is awaited there is returned here"
    swapped = {'AsyncIterator': 'Iterator', 'asynccontextmanager': 'contextmanager', '__aenter__': '__enter__',
               '__aexit__': '__exit__', '__aiter__': '__iter__'}

    def __init__(self, handles, homes):
        ours = 'Any', 'Self', 'Iterator', 'Mapping', 'contextmanager', 'cached_property'
        self.handles,self.known = handles,{*homes, *vars(builtins), *ours}

    def visit_Name(self, node):
        name = self.swapped.get(node.id, node.id)
        return named(f'_{name}' if name in self.handles else name if name in self.known else 'Any')

    def visit_Attribute(self, node): return node if node.attr == 'setter' else self.generic_visit(node)     # of a property

    def visit_FunctionDef(self, node):
        node = self.generic_visit(node)
        return ast.FunctionDef(self.swapped.get(node.name, node.name), node.args, node.body, node.decorator_list, node.returns)

    visit_AsyncFunctionDef = visit_FunctionDef

    def visit_ClassDef(self, node):
        node = self.generic_visit(node)
        bases = [b for b in node.bases if name_of(b).removeprefix('_') in (*self.handles, 'Mapping')]
        return ast.ClassDef(f'_{node.name}', bases, [], node.body, [])

    def visit_AnnAssign(self, node): return annotated(node.target.id, self.visit(node.annotation), node.value)


def awaits(node):
    "Has a class anything to await?"
    return any(isinstance(n, ast.AsyncFunctionDef) or getattr(n, 'id', '') == 'AsyncIterator' for n in ast.walk(node))


def blocking(texts, homes):
    "The stub of `UAV.blocking`, with `MAVCom` and all handles that it leads to as they are there; `texts`: all stubs"
    classes = {n.name: n for text in texts.values() for n in ast.parse(text).body if isinstance(n, ast.ClassDef)}
    handles,new = {},['MAVCom']
    while new:
        name = new.pop()
        handles[name] = classes[name]
        used = {n.id for n in ast.walk(classes[name]) if isinstance(n, ast.Name) and n.id.startswith('Remote')}
        bases = set(map(name_of, classes[name].bases))
        new += [n for n in sorted(used & {*classes}-{*handles}) if n in bases or awaits(classes[n])]
    made = [ast.fix_missing_locations(Plain(handles, homes).visit(node)) for node in handles.values()]
    used = {n.id for node in made for n in ast.walk(node) if isinstance(n, ast.Name)}
    imports = [f'from {homes[name]} import {name} as {name}' for name in sorted(used & {*homes}-{'Blocking'})]
    ours = ast.parse(texts['UAV.blocking']).body
    mavcom = next(n for n in ours if isinstance(n, ast.ClassDef) and n.name == 'BlockingMAVCom')
    mavcom.bases,mavcom.body = [named('_MAVCom')],[n for n in mavcom.body if getattr(n, 'name', '') != '__init__']
    imports += ['from collections.abc import Mapping', 'from contextlib import contextmanager',
                'from functools import cached_property']
    parts = [HEAD, *imports, *map(ast.unparse, [*ours, *made])]
    return '\n'.join(parts)+'\n'


def write(folder, to=None):
    "Write the stubs of the package in `folder` beside its modules, or into `to`; gives their paths"
    folder = Path(folder)
    paths = [path for path in sorted(folder.rglob('*.py')) if path.name != '_modidx.py']
    trees = {path: parsed(path.read_text(encoding='utf-8')) for path in paths}
    dotted = {path: '.'.join(path.relative_to(folder.parent).with_suffix('').parts) for path in paths}
    homes = {n.name: dotted[path] for path,tree in trees.items() for n in tree.body if isinstance(n, ast.ClassDef)}
    CLASSES.update({n.name: n for tree in trees.values() for n in tree.body if isinstance(n, ast.ClassDef)})
    METHODS.update({f'{n.name}.{f.name}': f for n in CLASSES.values() for f in filter(is_function, n.body)})
    functions = [f for tree in trees.values() for f in filter(is_function, tree.body)]
    METHODS.update({f'{name}.{f.name}': f for f in functions for name in patched(f)})
    made = [Path(to or folder)/path.relative_to(folder).with_suffix('.pyi') for path in paths]
    for old in {*Path(to or folder).rglob('*.pyi')}-{*made}: old.unlink()
    texts = {dotted[path]: stub(trees[path], homes) for path in paths}
    if 'UAV.blocking' in texts: texts['UAV.blocking'] = blocking(texts, homes)
    for path,file in zip(paths, made): file.write_text(texts[dotted[path]], encoding='utf-8')
    return made


def explain(folder):
    "Write parameters into the docstrings of a copy of the package in `folder`, for which `write` was called"
    for path in sorted(Path(folder).rglob('*.py')):
        if path.relative_to(folder).with_suffix('').parts[0] in EXPLAINED:
            path.write_text(explained(path.read_text(encoding='utf-8')), encoding='utf-8')


if __name__ == '__main__': print(len(write(Path(__file__).parent/'UAV')), 'stubs')
