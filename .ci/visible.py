#!/usr/bin/env python
"""Can a reader run what a page shows? Its visible code cells, in order and without the hidden ones, are to make every name they use.

    visible.py [--kernel] [PAGE …]      default: index, tutorials, how-tos and explanations

The cells are read, not run: that takes a second for all pages. With --kernel they are run too, in a real Jupyter kernel, without
what the site hides, without cells that are not for this machine (`#| gst` without GStreamer). The exit status is 1 when a page fails."""
import argparse, ast, builtins, json, os, re, sys
from pathlib import Path

from IPython.core.inputtransformer2 import TransformerManager

from installed import NEEDS,installed

LONGEST = 300                                                       # s for one page
HIDDEN = r'^#\s*\|\s*(hide\b|hide_input\b|echo:\s*false|include:\s*false|eval:\s*false|notest\b|slow\b|hardware\b)'
GIVEN = {*dir(builtins), 'get_ipython', 'display', '_', '__name__', '__file__'}        # what a notebook has from the beginning


def is_visible(cell, flags):
    "Whether a reader sees the source of `cell`, and can run it where `flags` are"
    source = ''.join(cell['source'])
    if cell['cell_type'] != 'code' or not source.strip() or re.search(HIDDEN, source, re.M): return False
    return all(flag in flags for flag in NEEDS if re.search(rf'^#\s*\|\s*{flag}\b', source, re.M))


def visible_cells(page, flags):
    "Number and source of each cell of `page` that a reader sees, and can run where `flags` are"
    cells = enumerate(json.loads(page.read_text(encoding='utf-8'))['cells'])
    return [(n, ''.join(cell['source'])) for n,cell in cells if is_visible(cell, flags)]


def starred(node):
    "The names that `from … import *` gives"
    module = __import__(node.module, fromlist=['*'])
    return getattr(module, '__all__', None) or [name for name in vars(module) if name[0] != '_']


class Names(ast.NodeVisitor):
    "The names that code makes, in a scope, and those that it takes from outside of it"
    def __init__(self): self.made,self.taken,self.later = set(),[],[]

    def visit_Name(self, node):
        if isinstance(node.ctx, ast.Store): self.made.add(node.id)
        elif node.id not in self.made: self.taken.append(node.id)

    def visit_AugAssign(self, node):
        self.visit(node.value)
        self.visit(ast.Name(node.target.id, ast.Load()) if isinstance(node.target, ast.Name) else node.target)

    def visit_Assign(self, node):
        for part in [node.value, *node.targets]: self.visit(part)

    def visit_NamedExpr(self, node):
        self.visit(node.value)
        self.visit(node.target)

    def visit_For(self, node):
        for part in [node.iter, node.target, *node.body, *node.orelse]: self.visit(part)
    visit_AsyncFor = visit_For

    def visit_alias(self, node): self.made.add((node.asname or node.name).split('.')[0])

    def visit_ImportFrom(self, node):
        if node.names[0].name == '*': self.made |= {*starred(node)}
        else: self.generic_visit(node)

    def visit_ExceptHandler(self, node):
        self.made |= {node.name} if node.name else set()
        self.generic_visit(node)

    def visit_MatchAs(self, node):
        self.made |= {node.name} if node.name else set()
        self.generic_visit(node)

    def visit_comprehension(self, node):
        for part in [node.iter, node.target, *node.ifs]: self.visit(part)

    def _comprehension(self, node):
        inner = Names()
        for part in [*node.generators, *([node.key, node.value] if isinstance(node, ast.DictComp) else [node.elt])]: inner.visit(part)
        self._take(inner)
        self.made |= {n.target.id for n in ast.walk(node) if isinstance(n, ast.NamedExpr)}
    visit_ListComp = visit_SetComp = visit_GeneratorExp = visit_DictComp = _comprehension

    def visit_FunctionDef(self, node):
        for part in [*node.decorator_list, *node.args.defaults, *filter(None, node.args.kw_defaults), node.returns, *_annotations(node.args)]:
            if part: self.visit(part)
        self.made.add(node.name)
        self._body(node.args, node.body)
    visit_AsyncFunctionDef = visit_FunctionDef

    def visit_Lambda(self, node):
        for part in [*node.args.defaults, *filter(None, node.args.kw_defaults)]: self.visit(part)
        self._body(node.args, [node.body])

    def visit_ClassDef(self, node):
        for part in [*node.decorator_list, *node.bases, *node.keywords]: self.visit(part)
        self.made.add(node.name)
        inner = Names()
        for part in node.body: inner.visit(part)
        self._take(inner)
        self.later += inner.later

    def _body(self, args, body):
        "A function may use what is made after it, as long as its cells come before it is called"
        inner = Names()
        inner.made = {a.arg for a in [*args.posonlyargs, *args.args, *args.kwonlyargs, args.vararg, args.kwarg] if a}
        for part in body: inner.visit(part)
        self.later += [name for name in inner.taken+inner.later if name not in inner.made]

    def _take(self, inner): self.taken += [name for name in inner.taken if name not in self.made]


def _annotations(args): return [a.annotation for a in [*args.posonlyargs, *args.args, *args.kwonlyargs, args.vararg, args.kwarg] if a]


def missing(page, flags):
    "`(cell, names)` of the cells of `page` that use what no visible cell before them made"
    made,later,python = set(GIVEN),[],TransformerManager()
    for n,source in visible_cells(page, flags):
        if source.lstrip().startswith(('%%', '!')): continue
        names = Names()
        names.visit(ast.parse(python.transform_cell(source)))
        lacking = {name for name in names.taken if name not in made}
        made |= names.made
        later.append((n, names.later))
        if lacking: yield n,sorted(lacking)
    for n,names in later:
        if lacking := {*names}-made: yield n,sorted(lacking)


def in_kernel(page, flags):
    "Run the visible cells of `page` in one Jupyter kernel, beside the page; `(cell, error)` of those that fail"
    import nbformat
    from nbclient import NotebookClient
    cells = visible_cells(page, flags)
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(source) for _,source in cells])
    client = NotebookClient(notebook, timeout=LONGEST, allow_errors=True, resources=dict(metadata=dict(path=str(page.parent))))
    with client.setup_kernel():
        for k,(n,_) in enumerate(cells):
            client.execute_cell(notebook.cells[k], k)
            for out in notebook.cells[k].outputs:
                if out['output_type'] == 'error': yield n,f"{out['ename']}: {out['evalue']}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('pages', nargs='*', type=Path)
    parser.add_argument('--kernel', action='store_true')
    args = parser.parse_args()
    nbs,folders = Path('nbs'),('tutorials', 'how_to', 'explanations')
    pages = args.pages or [nbs/'index.ipynb', *(page for folder in folders for page in sorted((nbs/folder).glob('*.ipynb')))]
    flags,failed = list(installed()) if args.kernel else list(NEEDS),0
    for page in pages:
        bad = [f'cell {n} has not been given {", ".join(names)}' for n,names in missing(page, flags)]
        if args.kernel: bad += [f'cell {n}: {why}' for n,why in in_kernel(page, flags)]
        failed += bool(bad)
        if bad: print(f'FAILED  {page}', *bad, sep='\n        ', flush=True)
    print(f'{len(pages)-failed} pages can be copied{" and run" if args.kernel else ""}, {failed} cannot')
    sys.stdout.flush()
    os._exit(bool(failed))                                          # a page may leave threads


if __name__ == '__main__': main()
