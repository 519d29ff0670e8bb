#!/usr/bin/env python3
"""Write README.md from nbs/index.ipynb and CHANGELOG.md from nbs/explanations/changelog.ipynb: `python .ci/readme.py [--check]`.

Their links lead to files of the clone, so they work on any git host and without a network; `nbdev-readme` needs Quarto, and leads to
the site. A link to a file that isn't there is an error. With --check nothing is written, and the exit status is 1 where a file differs."""
import difflib, json, os, re, sys
from pathlib import Path

WRITTEN = {'README.md': Path('nbs/index.ipynb'), 'CHANGELOG.md': Path('nbs/explanations/changelog.ipynb')}
SHOWN = 'echo: false'       # a code cell whose output is shown without its source; others are tests


def in_clone(source, notebook):
    "Markdown whose links begin at the top of the clone"
    def moved(link):
        place,_,anchor = link[1].partition('#')
        if '://' in place or not place: return link[0]
        place = os.path.normpath(notebook.parent/place)
        if not Path(place).exists(): sys.exit(f'{notebook}: a link leads to {place}, which is not there')
        return f']({place})' if place.endswith('.ipynb') else f']({place}{"#" if anchor else ""}{anchor})'     # a notebook has no anchors on a git host
    return re.sub(r'\]\(([^)\s]+)\)', moved, source)


def parts(notebook):
    "What a reader of `notebook` sees"
    for cell in json.loads(notebook.read_text(encoding='utf-8'))['cells']:
        source = ''.join(cell['source'])
        if cell['cell_type']=='markdown': yield in_clone(source, notebook)
        elif SHOWN in source: yield from (f'```\n{"".join(out["text"]).rstrip()}\n```' for out in cell['outputs'])


def main():
    differ = False
    for name,notebook in WRITTEN.items():
        old,new = Path(name).read_text(encoding='utf-8') if Path(name).exists() else '','\n\n'.join(parts(notebook))+'\n'
        if '--check' not in sys.argv: Path(name).write_text(new, encoding='utf-8')
        for line in difflib.unified_diff(old.splitlines(), new.splitlines(), name, f'from {notebook}', lineterm=''): print(line)
        differ |= old!=new
    return differ and '--check' in sys.argv


if __name__ == '__main__': sys.exit(main())
