#!/usr/bin/env python
"""Run what a reader copies: the visible code cells of a page, in order, and nothing else.

    visible.py [--kernel] [PAGE …]      default: index, tutorials, how-tos and explanations

Each page has a fresh process, two for each core run at a time: execnb's shell, or with --kernel a real Jupyter kernel. Cells whose source
the site hides are left out; cells that begin with `#| gst` or `#| browser` run where GStreamer or Chromium is installed.
What fails is tried once more, alone. The exit status is 1 when a page failed twice."""
import argparse, ctypes, json, os, re, subprocess, sys, tempfile, time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import psutil

from installed import NEEDS,in_browser,installed

LONGEST = 600                                                       # s for one page
HIDDEN = r'^#\s*\|\s*(hide\b|hide_input\b|echo:\s*false|include:\s*false|eval:\s*false|notest\b|slow\b|hardware\b)'


def is_visible(cell, flags):
    "Whether a reader sees the source of `cell`, and can run it where `flags` are"
    source = ''.join(cell['source'])
    if cell['cell_type'] != 'code' or not source.strip() or re.search(HIDDEN, source, re.M): return False
    return all(flag in flags for flag in NEEDS if re.search(rf'^#\s*\|\s*{flag}\b', source, re.M))


def visible_cells(page, flags):
    "Number and source of each cell of `page` that a reader sees, and can run where `flags` are"
    cells = enumerate(json.loads(page.read_text(encoding='utf-8'))['cells'])
    return [(n, ''.join(cell['source'])) for n,cell in cells if is_visible(cell, flags)]


def in_shell(sources):
    "Run each of `sources` in execnb's shell; for each its error, or None"
    from execnb.shell import CaptureShell
    shell = CaptureShell()
    for source in sources:
        error = next((o for o in shell.run(source) if o['output_type'] == 'error'), None)
        yield error and f"{error['ename']}: {error['evalue']}"


def in_kernel(sources):
    "Run each of `sources` in one Jupyter kernel; for each its error, or None"
    import nbformat
    from nbclient import NotebookClient
    notebook = nbformat.v4.new_notebook(cells=list(map(nbformat.v4.new_code_cell, sources)))
    client = NotebookClient(notebook, timeout=LONGEST, allow_errors=True)
    with client.setup_kernel():
        for n,cell in enumerate(notebook.cells):
            client.execute_cell(cell, n)
            error = next((o for o in cell.outputs if o['output_type'] == 'error'), None)
            yield error and f"{error['ename']}: {error['evalue']}"


def end(process):
    "Kill all that `process` has started, and what that has started"
    for child in process.children(recursive=True):
        try: child.kill()
        except psutil.NoSuchProcess: pass


def run_here(page, diary, run, flags):
    "Run `page` in this process; a line of `diary` for each cell that begins and each that fails. Nothing is left running"
    if sys.platform == 'linux': ctypes.CDLL(None).prctl(36, 1)      # PR_SET_CHILD_SUBREAPER: orphans stay our children
    cells = visible_cells(page, flags)
    os.chdir(page.parent)
    with open(diary, 'w', buffering=1) as lines:
        def note(*what): lines.write(json.dumps(what)+'\n')
        try:
            errors = run([source for _,source in cells])
            for n,source in cells:
                note('began', n)
                if error := next(errors): note('failed', n, error)
            note('ended', len(cells))
            errors.close()
        finally: end(psutil.Process())
    os._exit(0)


def run_apart(page, mode, flags):
    "Run `page` in a process of its own: how many cells it has, what failed, and its seconds"
    began = time.time()
    with tempfile.TemporaryDirectory() as folder:
        diary,output = Path(folder)/'diary',Path(folder)/'output'
        command = [sys.executable, __file__, '--diary', str(diary), *mode, '--flags', *flags, '--', str(page)]
        with output.open('w') as out: process = psutil.Popen(command, stdout=out, stderr=out, start_new_session=True)
        try: why = f'the process ended with {process.wait(LONGEST)}'
        except psutil.TimeoutExpired: why = f'no end after {LONGEST} s'
        finally:
            if process.is_running():
                end(process)
                process.kill()
                process.wait()
        lines = [json.loads(line) for line in diary.read_text().splitlines()] if diary.exists() else []
        failed = [f'cell {n}: {why}' for what,n,*rest in lines for why in rest if what == 'failed']
        if not lines or lines[-1][0] != 'ended':
            at = next((n for what,n,*_ in reversed(lines) if what == 'began'), None)
            failed.append(f'cell {at}: {why}\n{output.read_text()[-1000:]}')
            return None,failed,time.time()-began
        return lines[-1][1],failed,time.time()-began


def report(page, cells, failed, seconds):
    "Print how it went"
    name = '/'.join(page.parts[-2:])
    if not failed: print(f'ok      {name}: its {cells} visible cells run ({seconds:.0f} s)', flush=True)
    else:
        lines = [f'FAILED  {name}: visible cells fail ({seconds:.0f} s)', *(f.replace('\n', '\n            ') for f in failed)]
        print(*lines, sep='\n        ', flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('pages', nargs='*', type=Path)
    parser.add_argument('--kernel', action='store_true')
    parser.add_argument('--diary')
    parser.add_argument('--flags', nargs='*')
    args = parser.parse_args()
    if args.diary: run_here(args.pages[0].resolve(), args.diary, in_kernel if args.kernel else in_shell, args.flags)
    flags = args.flags
    if flags is None: flags = list(installed())
    nbs = Path('nbs')
    folders = 'explanations','how_to','tutorials'                   # the longest pages first
    pages = args.pages or [*(page for folder in folders for page in sorted((nbs/folder).glob('*.ipynb'))), nbs/'index.ipynb']
    pages = [page for page in pages if visible_cells(page, flags)]
    mode,again = ['--kernel'] if args.kernel else [],[]

    def first(page):
        result = run_apart(page, mode, flags)
        if result[1]: again.append((page, result))
        else: report(page, *result)

    def turns(pages):
        for page in pages: first(page)

    browsing,others = ([page for page in pages if in_browser(page)==is_so] for is_so in (True,False))
    with ThreadPoolExecutor(2*os.cpu_count()) as pool:              # most of their time they wait
        running = [pool.submit(turns, browsing), *(pool.submit(first, page) for page in others)]
        for one in running: one.result()
    bad = 0
    for page,(_,before,_) in again:
        result = run_apart(page, mode, flags)
        report(page, *result)
        bad += bool(result[1])
        print('the first time:', *before, sep='\n        ')
        print(f"{page.name}: failed {'twice' if result[1] else 'first, and passed the second time'}", flush=True)
    return bool(bad)


if __name__ == '__main__': sys.exit(main())
