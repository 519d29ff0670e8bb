#!/usr/bin/env python
"""Can a reader run what a page shows? Its visible code cells, in order and without the hidden ones, are to make every name they use.

    visible.py [--kernel] [PAGE …]      default: index, tutorials, how-tos and explanations

The cells are read, not run: that takes a second for all pages. With --kernel they are run too, in a real Jupyter kernel, without
what the site hides, without cells that are not for this machine (`#| gst` without GStreamer). The exit status is 1 when a page fails."""
import argparse, json, os, re, subprocess, sys, tempfile
from collections import defaultdict
from pathlib import Path

import nbformat
from nbformat.v4 import new_code_cell,new_notebook

from installed import NEEDS,installed

LONGEST = 300                                                       # s for one page
HIDDEN = r'^#\s*\|\s*(hide\b|hide_input\b|echo:\s*false|include:\s*false|eval:\s*false|notest\b|slow\b|hardware\b)'
GIVEN = 'builtins = ["get_ipython", "display", "_"]'                # what a notebook has from the beginning, in ruff's words
PYTHON = dict(language_info=dict(name='python'))


def visible_cells(page, flags):
    "The source of each cell of `page`; empty where a reader does not see it, or cannot run it where `flags` are"
    for cell in nbformat.read(page, as_version=4).cells:
        can_run = all(flag in flags for flag in NEEDS if re.search(rf'^#\s*\|\s*{flag}\b', cell.source, re.M))
        yield cell.source if cell.cell_type=='code' and can_run and not re.search(HIDDEN, cell.source, re.M) else ''


def spelled_out(source):
    "`from … import *` as an import of the names that it gives"
    def names(m):
        module = __import__(m[1], fromlist=['*'])
        return f'from {m[1]} import '+', '.join(getattr(module, '__all__', None) or [name for name in vars(module) if name[0]!='_'])
    return re.sub(r'^from ([\w.]+) import \*', names, source, flags=re.M)


def missing(pages, flags):
    "`{page: errors}` of the cells that use what no visible cell before them made, as ruff finds them"
    found = defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        for n,page in enumerate(pages):
            cells = [new_code_cell(spelled_out(source)) for source in visible_cells(page, flags)]
            nbformat.write(new_notebook(cells=cells, metadata=PYTHON), f'{folder}/{n}.ipynb')
        ran = subprocess.run([sys.executable, '-m', 'ruff', 'check', '--isolated', '--no-cache', '--select', 'F821,F823,E9', '--config', GIVEN,
                              '--output-format', 'json', folder], capture_output=True, text=True)
    if ran.returncode>1: sys.exit(ran.stderr)
    for one in json.loads(ran.stdout): found[pages[int(Path(one['filename']).stem)]].append(f'cell {one["cell"]-1}: {one["message"]}')
    return found


def in_kernel(page, flags):
    "What is wrong when the visible cells of `page` run in one Jupyter kernel, beside the page; empty when nothing is"
    from nbclient import NotebookClient,exceptions
    notebook = new_notebook(cells=[new_code_cell(source) for source in visible_cells(page, flags)])
    try: NotebookClient(notebook, timeout=LONGEST, resources=dict(metadata=dict(path=str(page.parent)))).execute()
    except exceptions.CellExecutionError as e: return [str(e)]
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('pages', nargs='*', type=Path)
    parser.add_argument('--kernel', action='store_true')
    args = parser.parse_args()
    nbs,folders = Path('nbs'),('tutorials', 'how_to', 'explanations')
    pages = args.pages or [nbs/'index.ipynb', *(page for folder in folders for page in sorted((nbs/folder).glob('*.ipynb')))]
    flags,failed = list(installed()) if args.kernel else list(NEEDS),0
    lacking = missing(pages, flags)
    for page in pages:
        bad = lacking[page]
        if args.kernel: bad += in_kernel(page, flags)
        failed += bool(bad)
        if bad: print(f'FAILED  {page}', *bad, sep='\n        ', flush=True)
    print(f'{len(pages)-failed} pages can be copied{" and run" if args.kernel else ""}, {failed} cannot')
    sys.stdout.flush()
    os._exit(bool(failed))                                          # a page may leave threads


if __name__ == '__main__': main()
