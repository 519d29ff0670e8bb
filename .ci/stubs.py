#!/usr/bin/env python3
"""Write a stub (`.pyi`) beside each module of UAV/, so that editors and mypy see what Jupyter sees.

Usage, from the project's root, in its development environment:
    python .ci/stubs.py [--check]
With --check nothing is written; exit status 1 when a stub is missing, left over, or not what the live classes give.

A class here grows by `@patch` in later modules, which no editor can follow. So we import the whole package and look at
the live classes: what they have is what the stub says. The words come from the source: annotations as written, plain
defaults, the docstring's first line, the comments beside parameters. Where nothing is written, we say what is certain
(`return self`, `return 'text'`, the class of an attribute that the constructor makes), and `Any` for the rest.
"""
import ast, builtins, copy, difflib, functools, inspect, io, logging, pkgutil, re, sys, tokenize, types, typing
from importlib import import_module
from importlib.util import resolve_name
from pathlib import Path

PACKAGE, WIDTH = 'UAV', 120
TOP = Path(__file__).parent.parent
NOTE = '# Written by .ci/stubs.py from the live classes: do not edit.'
SPECIAL = {'__init__', '__new__', '__call__', '__enter__', '__exit__', '__aenter__', '__aexit__', '__iter__', '__next__',
           '__aiter__', '__anext__', '__len__', '__bool__', '__getitem__', '__setitem__', '__delitem__', '__contains__',
           '__eq__', '__lt__', '__le__', '__add__', '__sub__', '__mul__', '__or__', '__and__', '__getattr__', '__await__',
           '__int__', '__float__', '__array__', '__fspath__', '__index__'}
MANAGERS = {'contextmanager', 'asynccontextmanager'}
FUNCTIONS = ast.FunctionDef, ast.AsyncFunctionDef
SCOPES = *FUNCTIONS, ast.ClassDef
DISPLAYS = {ast.JoinedStr: 'str', ast.Compare: 'bool', ast.List: 'list', ast.ListComp: 'list', ast.Tuple: 'tuple',
            ast.Dict: 'dict', ast.DictComp: 'dict', ast.Set: 'set', ast.SetComp: 'set'}     # they say their type
CHOICES = {'download': ('to', 'bytes', 'Path')}    # a parameter: what comes back without it, and with it
GENERATORS = {'Iterator', 'Iterable', 'Generator', 'AsyncIterator', 'AsyncIterable', 'AsyncGenerator'}


def is_public(name): return not name.startswith('_')


def statements(body):
    "The statements of `body`, and those within its `if`, `try` and `with`"
    for node in body:
        yield node
        for part in ('body', 'orelse', 'handlers', 'finalbody'):
            if not isinstance(node, SCOPES): yield from statements(getattr(node, part, []))


def inside(function):
    "All nodes of a function, without those of functions within it"
    waiting = list(function.body)
    while waiting:
        node = waiting.pop(0)
        yield node
        if not isinstance(node, (*SCOPES, ast.Lambda)): waiting[:0] = ast.iter_child_nodes(node)


def is_generator(function): return any(isinstance(node, (ast.Yield, ast.YieldFrom)) for node in inside(function))


def quoted(doc):
    "The first line of a docstring, as source; nothing when there is none"
    line = (doc or '').strip().split('\n')[0].strip()
    return '"'+line.replace('\\', r'\\').replace('"', r'\"')+'"' if line else ''


def indented(lines): return ['    '+line if line else '' for line in lines]


def documented(doc, docments):
    "The lines of a function's docstring: one, or more when something is said of its parameters"
    line = quoted(doc)
    if not docments: return [line] if line else []
    told = [f'    {names}: {comment}'.replace('\\', r'\\').replace('"""', "'''") for names, comment in docments]
    return [*(['""'+line[:-1], ''] if line else ['"""']), 'Args:', *told, '"""']


# ---- what is written -------------------------------------------------------------------------------------------------

class Source:
    "A module of the package: alive, and as it is written"
    def __init__(self, name):
        self.name, self.live = name, import_module(name)
        self.path = Path(self.live.__file__)
        text = self.path.read_text(encoding='utf-8')
        self.tree, tokens = ast.parse(text), tokenize.generate_tokens(io.StringIO(text).readline)
        self.comments = {t.start[0]: t.string.lstrip('# ') for t in tokens if t.type == tokenize.COMMENT}
        found = (node for node in ast.walk(self.tree) if isinstance(node, FUNCTIONS))
        self.functions = {min([node.lineno, *(d.lineno for d in node.decorator_list)]): node for node in found}
        self.imports = {}       # what each imported name is: `(module, name there or None)`
        for node in statements(self.tree.body): self._note_import(node)

    def docments(self, node):
        "`[(names, comment)]` of a function's parameters: one comment may speak of all that stand on its line"
        lines = {}
        for a in [*node.args.posonlyargs, *node.args.args, node.args.vararg, *node.args.kwonlyargs, node.args.kwarg]:
            if a and a.arg not in ('self', 'cls') and a.lineno < node.body[0].lineno: lines.setdefault(a.lineno, []).append(a.arg)
        return [(', '.join(names), self.comments[line]) for line, names in lines.items() if line in self.comments]

    def _note_import(self, node):
        if isinstance(node, ast.Import):
            for a in node.names:
                top = a.name.split('.')[0]
                self.imports[a.asname or top] = a.name if a.asname else top, None
        if not isinstance(node, ast.ImportFrom): return
        is_door = self.path.name == '__init__.py'
        package = self.name if is_door else self.name.rpartition('.')[0]
        module = resolve_name('.'*node.level+(node.module or ''), package) if node.level else node.module
        for a in node.names:
            if a.name == '*': self.imports.update({name: (module, name) for name in starred(import_module(module))})
            else: self.imports[a.asname or a.name] = (module, a.name)


def starred(module):
    "The names that `from module import *` gives"
    return getattr(module, '__all__', None) or [name for name in vars(module) if is_public(name)]


def sources():
    "All modules of the package by name, in the order of their names; each is imported"
    package = import_module(PACKAGE)
    names = [PACKAGE, *sorted(m.name for m in pkgutil.walk_packages(package.__path__, PACKAGE+'.'))]
    return {name: Source(name) for name in names if not name.endswith('._modidx')}


def written(f, book):
    "The `Source` and the node of a live function; `(None, None)` when it is not of this package"
    f = inspect.unwrap(f)
    source = book.get(getattr(f, '__module__', None))
    code = getattr(f, '__code__', None)
    if source is None or code is None or Path(code.co_filename) != source.path: return None, None
    return source, source.functions.get(code.co_firstlineno)


# ---- what is certain -------------------------------------------------------------------------------------------------

def merged(found):
    "One type for all that an attribute is given, or that a function returns"
    found = list(dict.fromkeys(found))
    if set(found) == {'int', 'float'}: return 'float'
    known = [one for one in found if one != 'None']
    if len(known) == 1 and 'Any' not in known: return known[0] if len(found) == 1 else known[0]+' | Any'
    return 'Any'


class Stub:
    "The stub of one module, as it is being written"
    def __init__(self, source, book):
        self.source, self.book = source, book
        self.imports, self.given = {}, {}       # `{(module, name there or None): name here}`: for us, and for others
        self.aliases, self.hidden = {}, set()       # of names that the class at hand has members of; those members
        live = source.live
        self.defined = {name: (source.name, name) for name in vars(live) if name not in source.imports}
        self.defined.update({name: source.imports[name] for name in getattr(live, '__all__', ()) if name in source.imports})

    # -- names

    def use(self, module, name=None, alias=None):
        "Import a name, or a module; what to call it here"
        if module == self.source.name and name: return name
        here = alias or name or module
        while self.is_taken(here, (module, name)): here = '_'+here
        return self.imports.setdefault((module, name), here)

    def is_taken(self, here, what):
        "Does `here` mean something else in this module?"
        own = self.defined.get(here, what)
        return own != what or any(used == here and key != what for key, used in self.imports.items())

    def own_class(self, cls):
        "What to call a class here; `Any` when it cannot be imported"
        if cls is type(None): return 'None'
        module, name = cls.__module__.split('._')[0], cls.__qualname__
        is_there = getattr(sys.modules.get(module), name, None) is cls
        if not is_there or module.startswith('_') or not (is_public(name) or self.is_ours(cls)): return 'Any'
        return self.visible(name, builtins=True) if module == 'builtins' else self.visible(self.use(module, name))

    def visible(self, name, builtins=False):
        "`name`, or another one when the class at hand has a member of that name"
        if name not in self.hidden: return name
        if builtins: return self.use('builtins')+'.'+name
        return self.aliases.setdefault(name, '_'+name)

    def resolve(self, name, source):
        "How `name`, which was written in `source`, is said here; `Any` when it is no type"
        live = getattr(source.live, name, getattr(builtins, name, self.exported(name)))
        if live is object: return 'Any'             # as a type it is the same, but nothing can be done with it
        if live is callable: return self.use('collections.abc', 'Callable')+'[..., Any]'
        if name in source.imports and not self.is_ours(live):
            module, there = source.imports[name]
            return self.visible(self.use(module, there, name))
        if isinstance(live, type): return self.own_class(live)
        if is_type(live) and hasattr(source.live, name): return self.visible(self.use(source.name, name))
        return 'Any'

    def is_ours(self, live): return getattr(live, '__module__', '').split('.')[0] == PACKAGE

    def exported(self, name):
        "What some module of the package exports as `name`: these names are unique"
        for source in self.book.values():
            if name in getattr(source.live, '__all__', ()) and hasattr(source.live, name): return getattr(source.live, name)

    def annotation(self, node, source):
        "An annotation as it is written, with names that mean the same here"
        if isinstance(node, ast.Constant) and isinstance(node.value, str): node = ast.parse(node.value, mode='eval').body
        stub = self
        class Names(ast.NodeTransformer):
            def visit_Name(self, node): return ast.parse(stub.resolve(node.id, source), mode='eval').body
            def visit_Call(self, node): return ast.Name('Any')
        return ast.unparse(Names().visit(copy.deepcopy(node)))

    def signed(self, annotation, source):
        "An annotation of an `inspect.Signature`: text, or a type"
        if annotation in (inspect.Parameter.empty, None, ''): return 'Any'
        if isinstance(annotation, type): return self.own_class(annotation)
        text = annotation if isinstance(annotation, str) else str(annotation)
        return self.annotation(ast.parse(text, mode='eval').body, source)

    # -- values

    def type_of(self, value):
        "The type of a live value"
        if isinstance(value, type): return f'type[{self.own_class(value)}]'
        is_bound = hasattr(type(value), '__get__')          # a function, or what looks different from outside
        if value is None or is_bound or isinstance(value, functools.partial): return 'Any'
        return self.own_class(type(value))

    def guess(self, node, source, params):
        "The type of an expression, when it is certain"
        if isinstance(node, ast.Constant): return 'None' if node.value is None else self.type_of(node.value)
        if isinstance(node, ast.Name): return params.get(node.id, 'Any')
        if isinstance(node, ast.Call): return self.guess_call(node.func, source)
        if isinstance(node, ast.IfExp): return merged(self.guess(one, source, params) for one in (node.body, node.orelse))
        is_not = isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not)
        name = 'bool' if is_not else DISPLAYS.get(type(node))
        return self.visible(name, builtins=True) if name else 'Any'

    def guess_call(self, function, source):
        "What a call gives: an object of a class, or what a function of ours says that it returns"
        names = ast.unparse(function).split('.')
        live = getattr(source.live, names[0], getattr(builtins, names[0], None))
        for name in names[1:]: live = getattr(live, name, None)
        is_class = isinstance(live, type) and live is not type
        if is_class: return self.own_class(live) if self.is_ours(live) else self.annotation(function, source)
        home, node = written(live, self.book) if isinstance(live, types.FunctionType) else (None, None)
        plain = node is not None and node.returns is not None and isinstance(node, ast.FunctionDef) and not is_generator(node)
        return self.annotation(node.returns, home) if plain and not names[1:] else 'Any'

    # -- functions

    def parameters(self, f, source, node, is_method):
        "`[(text, name, type)]` of the parameters of `f`"
        args = node.args
        nodes = {a.arg: a for a in [*args.posonlyargs, *args.args, *args.kwonlyargs, args.vararg, args.kwarg] if a}
        positional = [*args.posonlyargs, *args.args]
        defaults = dict(zip([a.arg for a in positional[len(positional)-len(args.defaults):]], args.defaults))
        defaults.update({a.arg: d for a, d in zip(args.kwonlyargs, args.kw_defaults) if d})
        found = []
        for n, p in enumerate(inspect.signature(f).parameters.values()):
            if n == 0 and is_method: found.append((p.name, p, 'Self'))
            else: found.append(self.parameter(p, nodes.get(p.name), defaults.get(p.name), source))
        return found

    def parameter(self, p, node, default, source):
        "One parameter: its text, itself, and its type"
        stars = {p.VAR_POSITIONAL: '*', p.VAR_KEYWORD: '**'}.get(p.kind, '')
        if node is not None: kind = self.annotation(node.annotation, source) if node.annotation else 'Any'
        else: kind = self.signed(p.annotation, source)
        if p.default is None and kind != 'Any' and 'None' not in kind: kind += ' | None'      # as is meant by `x:int=None`
        if kind == 'list' and p.default == (): kind += ' | tuple'                             # and by `x:list=()`
        text = f'{stars}{p.name}: {kind}'
        if p.default is not p.empty: text += ' = '+self.default(p.default, default)
        return text, p, {'*': 'tuple', '**': 'dict'}.get(stars, kind)

    def default(self, live, node):
        "A default as it is written, when that is short and means the same here"
        plain = isinstance(node, ast.Constant) or isinstance(node, ast.UnaryOp) and isinstance(node.operand, ast.Constant)
        if live is None and (plain or node is None): return 'None'
        return ast.unparse(node) if plain and len(ast.unparse(node)) <= 30 else '...'

    def listed(self, found):
        "The parameters with `/` and `*` where they belong"
        texts, kinds = [], [p.kind for _, p, _ in found]
        for n, (text, p, _) in enumerate(found):
            if p.kind == p.KEYWORD_ONLY and not {p.KEYWORD_ONLY, p.VAR_POSITIONAL} & set(kinds[:n]): texts.append('*')
            texts.append(text)
            if p.kind == p.POSITIONAL_ONLY and kinds[n+1:n+2] != [p.POSITIONAL_ONLY]: texts.append('/')
        return texts

    def scope(self, found, node):
        "`{name: type}` of the parameters that keep what they are given"
        stored = {n.id for n in inside(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}
        return {p.name: kind for _, p, kind in found if p.name not in stored}

    def returned(self, f, source, node, found):
        "What a call of `f` gives, and whether it is to be awaited"
        generator, is_async = is_generator(node), inspect.iscoroutinefunction(f)
        own = getattr(f, '__signature__', None)
        if own and own.return_annotation not in (own.empty, None): kind = self.signed(own.return_annotation, source)
        elif node.returns: kind = self.annotation(node.returns, source)
        else: kind = 'Any' if generator else self.guess_return(node, source, found)
        if not generator or kind.split('[')[0] in GENERATORS: return kind, is_async
        name, rest = ('AsyncGenerator', ', None') if isinstance(node, ast.AsyncFunctionDef) else ('Generator', ', None, None')
        return f'{self.use("collections.abc", name)}[{kind}{rest}]', False

    def guess_return(self, node, source, found):
        "What a function without an annotation returns, when it is certain"
        last, values = node.body[-1], [n.value for n in inside(node) if isinstance(n, ast.Return) and n.value]
        if node.name == '__init__': return 'None'
        if node.name == '__new__': return self.use('typing_extensions', 'Self')
        says_nothing = isinstance(last, ast.Pass) or isinstance(last, ast.Expr) and isinstance(last.value, ast.Constant)
        is_hook = len(node.body) == 1 and says_nothing and not values
        if isinstance(last, ast.Raise) or is_hook: return 'Any'
        if not values: return 'None'
        if not isinstance(last, ast.Return): return 'Any'
        same = {ast.unparse(v) for v in values}
        if len(same) == 1 and isinstance(values[0], ast.Name) and self.is_passed_on(values[0].id, node, found): return 'T'
        kind = merged(self.guess(v, source, self.scope(found, node)) for v in values)
        if kind == 'Self': return self.use('typing_extensions', 'Self')
        return 'Any' if 'Any' in kind or kind == 'T' else kind

    def is_passed_on(self, name, node, found):
        "Does the function return its parameter `name`, of which nothing is said, as it came?"
        plain = any(text.startswith(name+':') for text, _, _ in found)          # not `*name`
        return plain and self.scope(found, node).get(name) == 'Any'

    def function(self, name, f, decorators=(), is_method=False):
        "The lines of a function or method"
        source, node = written(f, self.book)
        if node is None: return self.unwritten(name, f, decorators)
        decorators = [*decorators]
        managers = [d.id for d in node.decorator_list if isinstance(d, ast.Name) and d.id in MANAGERS]
        decorators += [self.use('contextlib', manager) for manager in managers]
        if getattr(f, '__isabstractmethod__', False): decorators.append(self.use('abc', 'abstractmethod'))
        found = self.parameters(f, source, node, is_method)
        kind, is_async = self.returned(f, source, node, found)
        if kind == 'T': kind = self.passed_on(node, found)
        if name in CHOICES: return self.overloads(name, found, is_async, decorators, f.__doc__, source.docments(node))
        return self.lay_out(name, self.listed(found), kind, is_async, decorators, f.__doc__, source.docments(node))

    def overloads(self, name, found, is_async, decorators, doc, docments):
        "The lines of a function that gives something else when one of its parameters is given: by name, or in its place"
        chosen, without, given = CHOICES[name]
        texts, names = [text for text, _, _ in found], [p.name for _, p, _ in found]
        n = names.index(chosen)
        kind = f'{chosen}: '+texts[n].partition(': ')[2].replace(' | None = None', '')
        required = [text.partition(' = ')[0] for text in texts[:n]]
        ways = [([*texts[:n], f'{chosen}: None = None', *texts[n+1:]], without),
                ([*texts[:n], '*', kind, *texts[n+1:]], given), ([*required, kind, *texts[n+1:]], given)]
        decorators = [*decorators, self.use('typing', 'overload')]
        told = [(doc, docments), ('', []), ('', [])]
        return [line for way, say in zip(ways, told) for line in self.lay_out(name, *way, is_async, decorators, *say)]

    def passed_on(self, node, found):
        "Write the type variable into the parameter that comes back"
        name = next(n.value.id for n in inside(node) if isinstance(n, ast.Return) and n.value)
        found[:] = [(text.replace(': Any', ': _T', 1) if p.name == name else text, p, k) for text, p, k in found]
        return '_T'

    def unwritten(self, name, f, decorators):
        "The lines of a function that was not written in this package"
        texts = [*([] if 'staticmethod' in decorators else ['self']), '*args: Any', '**kwargs: Any']
        return self.lay_out(name, texts, 'Any', inspect.iscoroutinefunction(f), decorators, f.__doc__)

    def lay_out(self, name, texts, kind, is_async, decorators, doc, docments=()):
        "The lines of a function; what is said of its parameters goes into the docstring, where editors look for it"
        lines = [f'@{d}' for d in decorators]
        head, tail = ('async ' if is_async else '')+f'def {name}(', f') -> {kind}:'
        body = documented(doc, docments)
        one = head+', '.join(texts)+tail
        if len(one) <= WIDTH-4: lines.append(one)
        else: lines += wrapped(head, texts, tail, 8)
        if body: return [*lines, *indented(body)]
        return [*lines[:-1], lines[-1]+' ...']

    # -- classes

    def attributes(self, cls):
        "`{name: type}` of the public attributes of a class, and of its objects where the bases say nothing of them"
        bases = {name: value for base in reversed(cls.__mro__[1:]) for name, value in vars(base).items()}
        own = {name: value for name, value in vars(cls).items() if is_public(name) and is_data(value)}
        kinds = {name: self.class_attribute(value, bases.get(name)) for name, value in own.items()}
        for name, found in self.assigned(cls).items():
            said = vars(cls).get(name, bases.get(name))
            if said is not None or not is_public(name): continue
            kind = merged([*found, *(['None'] if name in own or name in bases else [])])
            kinds[name] = 'Any' if kind == 'None' else kind
        return kinds

    def class_attribute(self, value, inherited):
        "The type of a value in a class; a subclass may put a list in the place of a tuple, and whatever in that of a property"
        if inherited is not None and not is_data(inherited): return 'Any'
        kind = self.type_of(value)
        return self.use('collections.abc', 'Sequence') if kind == 'tuple' else kind

    def assigned(self, cls):
        "`{name: [type]}` of what the methods of `cls` assign to attributes of their objects, the constructor first"
        kinds = {}
        functions = [f for f in map(function_of, vars(cls).values()) if f]
        for f in sorted(functions, key=lambda f: f.__name__ != '__init__'):
            source, node = written(f, self.book)
            if node is None or not node.args.args: continue
            params = self.scope(self.parameters(f, source, node, True), node)
            me = 'self' if f.__name__ == '__new__' else node.args.args[0].arg
            for name, value in assignments(node, me):
                kind = params.get(name, 'Any') if value is None else self.guess(value, source, params)
                kinds.setdefault(name, []).append('Any' if kind == 'Self' else kind)
        return kinds

    def fields(self, node, source):
        "`(name, line)` of each field of a dataclass or a NamedTuple, as it is written"
        is_tuple = node.bases and ast.unparse(node.bases[0]) == 'NamedTuple'
        for n in node.body:
            if not isinstance(n, ast.AnnAssign): continue
            name, default = n.target.id, ' = ...' if has_default(n.value) else ''
            hides = '  # type: ignore[assignment]' if is_tuple and name in dir(tuple) else ''
            yield name, f'{name}: {self.annotation(n.annotation, source)}{default}{hides}'

    def bases(self, cls, node, source):
        "The bases as they are written; what fastcore's `GetAttr` does is written out below"
        names = [self.annotation(b, source) for b, live in zip(node.bases, cls.__bases__) if live.__name__ != 'GetAttr']
        names += [f'{k.arg}={self.annotation(k.value, source)}' for k in node.keywords if k.arg]
        return f'({", ".join(names)})' if names else ''

    def passed_through(self, cls, own):
        "Members that fastcore's `GetAttr` gives from the object in the attribute that `_default` names"
        if not any(base.__name__ == 'GetAttr' for base in cls.__bases__): return {}, False
        kind = own.get(cls._default, 'Any').split(' |')[0]
        there = self.exported(kind)
        if not isinstance(there, type): return {}, True
        return {n: k for n, k in self.attributes(there).items() if n not in vars(cls)}, False

    def member(self, name, value):
        "The lines of one method or property"
        if isinstance(value, property): return self.property(name, value)
        kinds = {staticmethod: 'staticmethod', classmethod: 'classmethod'} if name != '__new__' else {}
        decorators = [kinds[type(value)]] if type(value) in kinds else []
        if isinstance(value, functools.cached_property): decorators = [self.use('functools', 'cached_property')]
        return self.function(name, function_of(value), decorators, is_method=decorators != ['staticmethod'])

    def property(self, name, value):
        "The lines of a property, and of its setter"
        get = value.fget
        if written(get, self.book)[1] is None: lines = self.lay_out(name, ['self'], 'Any', False, ['property'], value.__doc__)
        else: lines = self.function(name, get, ['property'], True)
        if value.fset: lines += self.lay_out(name, ['self', 'value: Any'], 'None', False, [f'{name}.setter'], None)
        return lines

    def klass(self, cls, node, source):
        "The lines of a class"
        methods = {name: value for name, value in vars(cls).items() if self.is_told(name, value)}
        self.hidden, self.aliases = {*methods, *(n for n in vars(cls) if is_public(n))}, {}
        words = [ast.unparse(d) for d in node.decorator_list]
        dataclass = self.use('dataclasses', 'dataclass')
        decorators = ['@'+word.replace('dataclass', dataclass) for word in words if 'dataclass' in word]
        fields = dict(self.fields(node, source)) if decorators or '_fields' in vars(cls) else {}
        own = {} if is_enum(cls) else self.attributes(cls)
        more, opaque = self.passed_through(cls, own)
        if more: methods.pop('__getattr__', None)       # what it gives is written out: all else is an error
        doc = '' if is_generated(cls) else quoted(vars(cls).get('__doc__'))
        body = [doc] if doc else []
        if is_enum(cls): body += [f'{name} = {value.value!r}' for name, value in cls.__members__.items()]
        body += fields.values()
        body += [f'{name}: {kind}' for name, kind in {**more, **own}.items() if name not in fields and name not in methods]
        for name, value in methods.items(): body += self.member(name, value)
        if opaque: body += self.lay_out('__getattr__', ['self', 'name: str'], 'Any', False, [], None)
        head = f'class {node.name}{self.bases(cls, node, source)}:'
        aliases = [f'{alias} = {name}' for name, alias in self.aliases.items()]
        self.hidden = set()
        return [*aliases, *decorators, *([head, *indented(body)] if body else [head+' ...'])]

    def is_told(self, name, value):
        "Is this a method that the stub tells of? Those that a dataclass or a NamedTuple makes by itself are known to all"
        f = function_of(value)
        if not (is_public(name) or name in SPECIAL): return False
        if isinstance(value, property): return True
        return f is not None and (written(f, self.book)[1] is not None or is_public(name) and self.is_ours(f))

    # -- the module

    def definition(self, node):
        "`{name: lines}` of what a statement of the module defines"
        source, live = self.source, self.source.live
        if isinstance(node, ast.ClassDef):
            cls = getattr(live, node.name, None)
            is_here = isinstance(cls, type) and cls.__module__ == source.name
            return {node.name: ['', *self.klass(cls, node, source)]} if is_here else {}
        if isinstance(node, FUNCTIONS): return {node.name: self.module_function(node)} if is_public(node.name) else {}
        targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign) else []
        parts = [n for target in targets for n in ast.walk(target) if isinstance(n, ast.Name)]
        names = [n.id for n in parts if isinstance(n.ctx, ast.Store) and hasattr(live, n.id)]
        told = [name for name in names if is_public(name) or is_type(getattr(live, name))]
        return {name: self.constant(name, getattr(live, name), node.value if len(names) == 1 else None) for name in told}

    def constant(self, name, value, node):
        "A constant, or another name of a type"
        is_alias = isinstance(node, (ast.Name, ast.Attribute, ast.Subscript, ast.BinOp))
        if is_type(value) and is_alias: return [f'{name} = {self.annotation(node, self.source)}']
        if isinstance(value, type) and (value.__module__, value.__name__) == (self.source.name, name): return self.made(value)
        if isinstance(value, types.FunctionType): return self.function(name, value)
        return [f'{name}: {self.type_of(value)}']

    def made(self, cls):
        "The lines of a class that a call has made: of an Enum, or of a named tuple"
        if is_enum(cls): fields = [f'{name} = {int(value)}' for name, value in cls.__members__.items()]
        else: fields = [f'{name}: Any' for name in cls._fields]
        base = self.own_class(cls.__base__) if is_enum(cls) else self.use('typing', 'NamedTuple')
        return ['', f'class {cls.__name__}({base}):', *('    '+field for field in fields)]

    def module_function(self, node):
        "The lines of a function of the module; none when it went into a class"
        is_patch = any(ast.unparse(d).split('(')[0] == 'patch' for d in node.decorator_list)
        live = getattr(self.source.live, node.name, None)
        if is_patch or live is None: return []
        if isinstance(live, types.FunctionType): return self.function(node.name, live)
        return [f'{node.name}: {self.type_of(live)}']

    def passed(self, defined):
        "What the module gives of others: the names of its `__all__`, and all that a door imports"
        live, source = self.source.live, self.source
        is_door, listed = source.path.name == '__init__.py', list(getattr(live, '__all__', []))
        names = [*listed, *([n for n in source.imports if is_public(n)] if is_door else []), *given_late(source)]
        return [name for name in dict.fromkeys(names) if name not in defined and hasattr(live, name)]

    def pass_on(self, name):
        "Give `name` of another module; the lines when no import says it well"
        value = getattr(self.source.live, name)
        if isinstance(value, (int, float, str, bytes)) and not self.of_ours(name): return [f'{name}: {self.type_of(value)}']
        if isinstance(value, types.ModuleType):
            module, _, leaf = value.__name__.rpartition('.')
            origin = (module, leaf) if module else (leaf, None)
        elif self.is_ours(value) and hasattr(value, '__name__'): origin = value.__module__, value.__name__
        else: origin = self.source.imports[name]
        self.given[origin] = name
        return []

    def of_ours(self, name): return self.source.imports.get(name, ('',))[0].split('.')[0] == PACKAGE

    def text(self):
        "The whole stub"
        found = {}          # what is defined twice counts as defined last
        for node in statements(self.source.tree.body): found.update(self.definition(node))
        body = [line for name in self.passed(found) for line in self.pass_on(name)]
        for lines in found.values(): body += ['', *lines[1:]] if lines[:1] == [''] or body[-1:] == [''] else lines
        listed = getattr(self.source.live, '__all__', None)
        if listed is not None: body += ['', *wrapped('__all__ = [', [repr(n) for n in dict.fromkeys(listed)], ']')]
        said = '\n'.join(body)
        variable = ["_T = TypeVar('_T')"] if re.search(r'\b_T\b', said) else []
        for name in ['Any', *(['TypeVar'] if variable else [])]: self.use('typing', name)
        doc = [quoted(self.source.live.__doc__)] if quoted(self.source.live.__doc__) else []
        parts = [*doc, NOTE, *self.import_lines('\n'.join([*variable, said])), *variable, '', *body]
        return '\n'.join(parts).rstrip('\n')+'\n'

    def import_lines(self, said):
        "The imports that `said` needs, those of one module on one line; what we give to others is said to be itself"
        modules, plain = {}, []
        needed = [(what, here) for what, here in self.imports.items() if re.search(rf'(?<!\.)\b{here}\b', said)]
        for given, pairs in ((False, needed), (True, self.given.items())):
            for (module, name), here in pairs:
                own = f' as {here}' if given or here != (name or module) else ''
                if name is None: plain.append(f'import {module}{own}')
                else: modules.setdefault(module, []).append(name+own)
        named = (wrapped(f'from {module} import ', sorted(modules[module])) for module in sorted(modules))
        return [*sorted(plain), *(line for lines in named for line in lines)]


def wrapped(head, items, tail='', indent=4):
    "`head`, the items with commas, and `tail`, on as few lines as fit"
    one = head+', '.join(items)+tail
    if len(one) <= WIDTH: return [one]
    if not tail: head, tail = head+'(', ')'
    lines = ['']
    for item in items:
        if len(lines[-1])+len(item)+indent+2 > WIDTH: lines.append('')
        lines[-1] += item+', '
    last = lines[-1].rstrip(' ,') if items[-1].startswith('**') else lines[-1].rstrip()
    return [head, *(' '*indent+line.rstrip() for line in [*lines[:-1], last]), tail]


def is_type(value): return isinstance(value, (type, types.UnionType, types.GenericAlias)) or typing.get_origin(value) is not None
def is_enum(cls): return hasattr(cls, '__members__')
def is_generated(cls): return (vars(cls).get('__doc__') or '').startswith(cls.__name__+'(')


def is_data(value):
    "Is it an attribute of a class that is neither a method nor a property?"
    hidden = ('_tuplegetter', 'member_descriptor', '_abc_data')
    return function_of(value) is None and not isinstance(value, property) and type(value).__name__ not in hidden


def has_default(value):
    "Has a field whose default is written as `value` one? Not when it is a `field()` without any"
    is_field = isinstance(value, ast.Call) and ast.unparse(value.func).split('.')[-1] == 'field'
    return value is not None and (not is_field or any(k.arg in ('default', 'default_factory') for k in value.keywords))


def function_of(value):
    "The function within a member of a class; `None` when it is none"
    if isinstance(value, property): return value.fget
    if isinstance(value, functools.cached_property): return value.func
    if isinstance(value, (staticmethod, classmethod)): return value.__func__
    return value if isinstance(value, types.FunctionType) else None


def assignments(node, me):
    "`(name, value)` of each attribute that a method gives its object; `None` for a parameter that `store_attr` keeps"
    for n in inside(node):
        if isinstance(n, ast.Call) and ast.unparse(n.func) == 'store_attr':
            for name in stored(n, node): yield name, None
        pairs = [pair for target in n.targets for pair in paired(target, n.value)] if isinstance(n, ast.Assign) else []
        for target, value in pairs:
            if isinstance(target, ast.Attribute) and ast.unparse(target.value) == me: yield target.attr, value


def paired(target, value):
    "Each target of an assignment with its value"
    if not isinstance(target, (ast.Tuple, ast.List)): return [(target, value)]
    parts = value.elts if isinstance(value, (ast.Tuple, ast.List)) else []
    same = len(parts) == len(target.elts) and not any(isinstance(part, ast.Starred) for part in [*parts, *target.elts])
    values = parts if same else [ast.Name('…')]*len(target.elts)
    return [pair for t, v in zip(target.elts, values) for pair in paired(t, v)]


def stored(call, node):
    "The names that a call of fastcore's `store_attr` keeps"
    but = [k.value.value for k in call.keywords if k.arg == 'but']
    if call.args: return [name.split(':')[0].strip() for name in call.args[0].value.split(',')]
    names = [a.arg for a in [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs][1:]]
    return [name for name in names if name not in ','.join(but).split(',')]


def given_late(source):
    "Names that the module's `__getattr__` gives when they are asked for"
    late = next((n for n in source.tree.body if isinstance(n, ast.FunctionDef) and n.name == '__getattr__'), None)
    words = [n.value for n in ast.walk(late) if isinstance(n, ast.Constant) and isinstance(n.value, str)] if late else []
    return [word for word in words if word.isidentifier() and hasattr(source.live, word)]


def main():
    logging.disable(logging.CRITICAL)
    sys.path.insert(0, str(TOP))
    book = sources()
    stubs = {source.path.with_suffix('.pyi'): Stub(source, book).text() for source in book.values()}
    left_over = sorted(set((TOP/PACKAGE).rglob('*.pyi'))-set(stubs))
    old = {path: path.read_text(encoding='utf-8') if path.exists() else '' for path in stubs}
    changed = [path for path, text in stubs.items() if old[path] != text]
    if '--check' not in sys.argv:
        for path in changed: path.write_text(stubs[path], encoding='utf-8')
        for path in left_over: path.unlink()
        print(f'{len(stubs)} stubs, {len(changed)} written, {len(left_over)} removed')
        return 0
    for path in changed:
        names = str(path.relative_to(TOP)), 'from the live classes'
        print('\n'.join(difflib.unified_diff(old[path].splitlines(), stubs[path].splitlines(), *names, lineterm='', n=0)))
    for path in left_over: print(f'{path.relative_to(TOP)}: there is no such module')
    if changed or left_over: print('stubs are not current: run `python .ci/stubs.py`')
    return int(bool(changed or left_over))


if __name__ == '__main__': sys.exit(main())
