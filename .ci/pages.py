#!/usr/bin/env python
"""Does every page fit? Render all pages, look at them in Chromium at two widths, and fail when something does not fit.

Usage, from the project's root, in its development environment:
    python .ci/pages.py [--only WORD] [--dark] [--as-is]

It counts elements wider than their column, letters in drawings under 11 px as they are shown, pictures that do not load
or have no alternative text; lychee finds links and anchors that lead nowhere. What scrolls inside a box of its own is fine.

This is not Quarto, which renders the real site. The cells are nbdev's (`_proc`, where the pages are written, too), pandoc is the same
program, the elements and classes of cells, outputs and figures, `nbs/styles.css`, the colours and fonts of `nbs/theme*.scss` and the
widths of `_quarto.yml` are those of the site. Bootstrap, the bars at the top and at the sides, tabsets and mermaid diagrams are not
there; callouts are plain boxes.
"""
import argparse, base64, functools, html, json, os, re, subprocess, sys, threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import IPython.core.history, nbdev.config, nbformat, pypandoc, yaml
from nbdev.config import get_config
from nbdev.serve import proc_nbs

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests import settings
from tests.reference import site_address

class HistoryThread(IPython.core.history.HistorySavingThread):
    "IPython 9.18 means this thread to be a daemon, and hides `Thread.daemon` by an attribute: processes of `proc_nbs` never ended"
    daemon = threading.Thread.daemon
    def __init__(self, *args):
        super().__init__(*args)
        self.daemon = True

IPython.core.history.HistorySavingThread = HistoryThread        # in the processes that nbdev spawns too: they import this file
nbdev.config._load_toml = functools.cache(nbdev.config._load_toml)      # it is read 190 times for a page, a quarter of the time

PROC = Path('_proc').absolute()
WIDTHS = 1400, 390      # a laptop's window, and a phone
LEAST_LETTERS = 11      # px
READER = 'markdown+autolink_bare_uris+emoji-yaml_metadata_block'
LOOK = '''
body{{margin:0;font:17px/1.6 {font-family-sans-serif};background:{body-bg};color:{body-color}}} a{{color:{link-color}}}
code{{color:{code-color};background:{code-bg}}} pre code{{color:inherit;background:none}}
#quarto-content{{display:grid;justify-content:center;column-gap:1.5em;padding:0 1.5em;
  grid-template-columns:{sidebar-width} minmax(0,calc({body-width} - 3em)) {margin-width}}}
main{{grid-column:2;min-width:0}}
@media (max-width:991px){{#quarto-content{{grid-template-columns:minmax(0,1fr)}} main{{grid-column:1}}}}
code,pre{{font-family:{font-family-monospace};font-size:.875em}} pre code{{font-size:inherit}}
pre{{margin:0 0 1rem;overflow:auto}} div.sourceCode,main>pre{{background:{code-block-bg};padding:.4em}}
table{{border-collapse:collapse}} td,th{{padding:.5rem;border-bottom:1px solid {border-color};text-align:left}}
figure{{margin:0 0 1rem}} .img-fluid{{max-width:100%;height:auto}} .callout{{border-left:5px solid #0d6efd;padding:.3rem .8rem}}'''


def options(source):
    "Quarto's `#| key: value` lines, and the code below them"
    found,lines = {},source.split('\n')
    while lines and lines[0].startswith('#|'):
        m = re.match(r'#\|\s*([\w-]+):\s*(.*)', lines.pop(0))
        if m: found[m[1]] = str(yaml.safe_load(m[2]) if m[2] else '')
    return found,'\n'.join(lines)


def fence(code, language=''):
    ticks = '`'*max([3, *(1+len(x) for x in re.findall('`+', code))])
    return f'{ticks} {language}\n{code}\n{ticks}\n'


def raw(words): return f'\n```{{=html}}\n{words}\n```\n'
def boxed(kind, words): return f'{raw(f"<div class={json.dumps(kind)}>")}\n{words}\n{raw("</div>")}'


def smallest_letters(svg):
    "The least font size in an SVG as a part of its width; 0 without letters"
    sizes = re.findall(r'font(?:-size)?\s*[:=]\s*"?[^;"}]*?([\d.]+)px', svg) if '<text' in svg else []
    wide = re.search(r'viewBox="\S+ \S+ ([\d.]+)', svg) or re.search(r'<svg[^>]* width="([\d.]+)', svg)
    return min(map(float, sizes), default=0)/float(wide[1]) if wide else 0


def figure(kind, data, alt):
    "The figure of an image; its address ends as the file's that Quarto writes, which `nbs/styles.css` looks at"
    is_svg = kind=='image/svg+xml'
    letters,coded = (smallest_letters(data), base64.b64encode(data.encode()).decode()) if is_svg else (0, data.replace('\n', ''))
    alt = f' alt="{html.escape(alt)}"' if alt else ''
    return raw(f'<figure class="figure"><p><img src="data:{kind};base64,{coded}#.{kind[6:9]}"{alt} class="img-fluid figure-img" data-letters="{letters}"></p></figure>')


def output(out, how):
    "What Quarto shows of an output: HTML before pictures, pictures before text"
    if out.output_type=='stream': return boxed(f'cell-output cell-output-{out.name}', fence(out.text))
    data = out.get('data', {})
    if how.get('output')=='asis' and 'text/markdown' in data: return data['text/markdown']
    kind = next((kind for kind in ('text/html','text/markdown','image/svg+xml','image/png','image/jpeg','image/webp') if kind in data), None)
    if kind is None: shown = fence(data.get('text/plain', ''))
    elif kind=='text/html': shown = raw(data[kind])
    elif kind=='text/markdown': shown = data[kind]
    else: shown = figure(kind, data[kind], how.get('fig-alt') or how.get('fig-cap'))
    return boxed('cell-output cell-output-display', shown)


def markdown(cell):
    "What Quarto shows of a cell"
    if cell.cell_type!='code': return cell.source if cell.cell_type=='markdown' or not cell.source.startswith('---') else ''
    how,code = options(cell.source)
    if how.get('include','').lower()=='false': return ''
    parts = []
    if how.get('echo','').lower()!='false' and code.strip():
        parts = [fence(code, 'python')]
        if how.get('code-fold','').lower() in ('true','show'):
            parts = [raw(f'<details class="code-fold"><summary>{how.get("code-summary", "Code")}</summary>'), *parts, raw('</details>')]
    if how.get('output','').lower()!='false': parts += [output(o, how) for o in cell.get('outputs', [])]
    return boxed('cell', '\n'.join(parts)) if parts else ''


class Page:
    "One processed notebook, and the HTML that becomes of it"
    def __init__(self, notebook):
        self.notebook,self.cells,self.front = notebook,nbformat.read(notebook, as_version=4).cells,{}
        for cell in self.cells:
            head = re.match(r'---\n(.*?)\n---', cell.source, re.S)
            if cell.cell_type=='raw' and head: self.front.update(yaml.safe_load(head[1]) or {})
        self.path = notebook.with_name(self.front.get('output-file', f'{notebook.stem}.html'))

    def relink(self, words, paths):
        "Links to notebooks become links to their pages, `paths`"
        def there(m):
            target = Path(os.path.normpath(self.notebook.parent/m[1]))
            return f']({os.path.relpath(paths[target], self.path.parent)}{m[2] or ""})' if target in paths else m[0]
        return re.sub(r'\]\((?!\w+:)([^)#\s]+\.ipynb)(#[^)]*)?\)', there, words)

    def render(self, paths, theme):
        "Write the page; what pandoc complains of"
        words = self.relink('\n\n'.join(map(markdown, self.cells)), paths)
        words = re.sub(r'```\{(\w+)\}', r'``` \1', words)
        done = subprocess.run([pypandoc.get_pandoc_path(), '-f', READER, '-t', 'html5', '--mathml', '--wrap=preserve'],
                              input=words, text=True, capture_output=True)
        title,description = (html.escape(str(self.front.get(key, ''))) for key in ('title','description'))
        self.path.write_text(f'''<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
            <link rel="stylesheet" href="{os.path.relpath(PROC, self.path.parent)}/page.css"></head><body class="quarto-{theme}"><div id="quarto-content">
            <main class="content"><header id="title-block-header"><h1 class="title">{title}</h1><div class="description">{description}</div></header>
            {done.stdout}</main></div></body></html>''')
        return done.stderr.strip()


MEASURE = r'''
const findings = [], main = document.querySelector('main'), column = main.getBoundingClientRect()
document.querySelectorAll('details').forEach(d => d.open = true)
const words = e => (e.getAttribute('alt') || e.id || e.textContent || e.getAttribute('src') || '').trim().replace(/\s+/g, ' ').slice(0, 70)
const scrolls = e => ['auto','scroll'].includes(getComputedStyle(e).overflowX)
const boxed = e => { for (let p = e.parentElement; p && p !== main; p = p.parentElement)
                       if (scrolls(p) && p.getBoundingClientRect().right <= column.right+1) return true }
if (document.documentElement.scrollWidth > innerWidth+1) findings.push(['page', document.documentElement.scrollWidth-innerWidth, 'the page itself scrolls sideways'])
const seen = new Set()
for (const e of main.querySelectorAll('*')) {
  if (seen.has(e.parentElement)) { seen.add(e); continue }
  const box = e.getBoundingClientRect()
  if (box.width && !e.closest('svg svg, math') && (box.right > column.right+1 || box.left < column.left-1) && !boxed(e)) {
    seen.add(e); findings.push(['wide', Math.round(Math.max(box.right-column.right, column.left-box.left)), e.tagName.toLowerCase()+': '+words(e)]) } }
for (const i of main.querySelectorAll('img')) {
  if (i.getAttribute('src').startsWith('http')) continue
  if (!i.naturalWidth) findings.push(['picture', 1, 'does not load: '+i.getAttribute('src').slice(0, 70)])
  if (!(i.getAttribute('alt') || '').trim() && !i.closest('[aria-hidden=true]') && i.getAttribute('role') !== 'presentation')
    findings.push(['alt', 1, 'img: '+i.getAttribute('src').slice(0, 70)])
  const letters = i.dataset.letters*i.getBoundingClientRect().width
  if (i.naturalWidth && letters && letters < LEAST-.05) findings.push(['letters', Math.round(10*(LEAST-letters))/10, words(i)]) }
for (const s of main.querySelectorAll('svg')) {
  if (s.parentElement.closest('svg') || s.getBoundingClientRect().width < 60) continue
  if (!s.querySelector('title') && !s.getAttribute('aria-label') && !s.closest('[aria-label],[aria-hidden=true]')) findings.push(['alt', 1, 'svg: '+words(s)])
  let least = 99
  for (const t of s.querySelectorAll('text')) if (t.textContent.trim()) least = Math.min(least, parseFloat(getComputedStyle(t).fontSize)*Math.abs(t.getScreenCTM().d))
  if (least < LEAST-.05) findings.push(['letters', Math.round(10*(LEAST-least))/10, words(s)]) }
return findings'''.replace('LEAST', str(LEAST_LETTERS))


SETTLED = r'''
const [done] = arguments, late = new Promise(end => setTimeout(end, 20000))
const ready = Promise.all([document.fonts.ready, ...[...document.images].map(image => image.decode().catch(() => {}))])
Promise.race([ready, late]).then(() => requestAnimationFrame(() => requestAnimationFrame(() => done())))'''


def look_at(pages):
    "`[(page, width, kind, by how much, what)]`, as Chromium shows them"
    from tests.browser import Browser
    findings = []
    with Browser() as browser:
        for path in pages:
            for n,width in enumerate(WIDTHS):
                browser.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', dict(width=width, height=900, deviceScaleFactor=1, mobile=False))
                if not n: browser.driver.get(path.as_uri())
                browser.driver.execute_async_script(SETTLED)         # the load event can come before a picture is decoded
                findings += [(path, width, *found) for found in browser.driver.execute_script(MEASURE)]
    return findings


def dead_links():
    "Links to pages, anchors and source files that are not there, as lychee finds them; the site is here, and so are the files of its repository"
    ours = settings()
    places = {f'{site_address()}/': PROC, f'{ours["git_url"]}/blob/{ours["branch"]}/': get_config().config_path}
    remaps = [f'--remap=^{address} {folder.as_uri()}/' for address,folder in places.items()]
    ran = subprocess.run(['lychee', '--offline', '--include-fragments', '--format=json', *remaps, str(PROC)], text=True, capture_output=True)
    if not ran.stdout: sys.exit(ran.stderr)
    errors = json.loads(ran.stdout)['error_map']
    return [(path, 0, 'link', 1, f'{one["url"]}: {one["status"]["text"]}') for path in errors for one in errors[path]]


def variables(file):
    "`{name: value}` of a theme's file"
    return dict(re.findall(r'^\$([\w-]+): (.+);$', Path(file).read_text(), re.M))


def contrast(one, other):
    "How many times one colour is brighter than another (WCAG 2.2)"
    def bright(colour):
        parts = [int(colour[i:i+2], 16)/255 for i in (1,3,5)]
        return sum(w*(p/12.92 if p<=.04045 else ((p+.055)/1.055)**2.4) for w,p in zip((.2126,.7152,.0722), parts))
    dark,light = sorted((bright(one), bright(other)))
    return (light+.05)/(dark+.05)


def readable():
    "Colours of a theme that can't be read on its background"
    pairs = ('body-color','body-bg'),('link-color','body-bg'),('code-color','code-bg'),('body-color','code-block-bg'),('sidebar-fg','sidebar-bg'),('navbar-fg','navbar-bg')
    themes = {name:variables(f'nbs/{name}.scss') for name in ('theme','theme-dark')}
    return [(f'{name}.scss', 0, 'contrast', 1, f'{a} on {b}: {contrast(theme[a], theme[b]):.1f}')
            for name,theme in themes.items() for a,b in pairs if contrast(theme[a], theme[b])<4.5]


def main():
    args = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    args.add_argument('--only', default='', help='a part of the names of pages to look at')
    args.add_argument('--dark', action='store_true', help='in the dark theme')
    args.add_argument('--as-is', action='store_true', help='take _proc as it is')
    args = args.parse_args()
    config = yaml.safe_load(Path('_quarto.yml').read_text())
    theme = 'dark' if args.dark else 'light'
    colours = variables(f'nbs/theme{"-dark" if args.dark else ""}.scss')
    if not args.as_is: proc_nbs(n_workers=2, force=True)
    (PROC/'page.css').write_text(LOOK.format(**config['format']['html']['grid'], **colours)+Path('nbs/styles.css').read_text())
    pages = [Page(notebook) for notebook in sorted(PROC.rglob('*.ipynb'))]
    paths = {page.notebook: page.path for page in pages}
    with ThreadPoolExecutor(2) as pool: complaints = list(pool.map(lambda page: page.render(paths, theme), pages))
    findings = [(page.path, 0, 'pandoc', 1, words) for page,words in zip(pages, complaints) if words]
    findings += readable()+dead_links()
    chosen = [page.path for page in pages if args.only in str(page.path)]
    findings += look_at(chosen)
    for path,width,kind,much,what in sorted(findings, key=lambda f: (f[2], -f[3]))[:200]:
        print(f'{kind:8}{much:6} px ' if kind in ('wide','page','letters') else f'{kind:18}', f'{width or "":5}', str(path).removeprefix(f'{PROC}/'), what)
    print(f'{len(chosen)} pages at {" and ".join(map(str, WIDTHS))} px:', ', '.join(f'{n} {kind}' for kind,n in Counter(f[2] for f in findings).items()) or 'all fits')
    return bool(findings)


if __name__=='__main__': sys.exit(main())
