#!/usr/bin/env python3
"""Write README.md from nbs/index.ipynb as `nbdev-readme` does, without needing Quarto.

Its links and pictures are relative, so they work in a bare clone and on any git host: `nbs/images/panel.webp`, and the
notebook in place of its page on the site. A link to a file that is not there is an error.

Usage, from the project's root, in its development environment:
    python .ci/readme.py [--check]
With --check nothing is written; exit status 1 when README.md differs from what the notebook gives.
"""
import difflib, json, re, subprocess, sys
from pathlib import Path
from tempfile import TemporaryDirectory
import pypandoc, yaml
from nbdev import serve_drv
from nbdev.processors import FilterDefaults

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests.reference import site_address

READER = "markdown-implicit_figures+emoji-yaml_metadata_block"
WRITER = ("commonmark+autolink_bare_uris+emoji+footnotes+gfm_auto_identifiers+pipe_tables+strikeout+task_lists+tex_math_dollars")


def text(value): return value if isinstance(value, str) else "".join(value or [])


def split_options(source):
    "Quarto's `#| key: value` lines, and the code below them"
    options, lines = {}, source.split("\n")
    while lines and lines[0].startswith("#|"):
        m = re.match(r"#\|\s*([\w-]+):\s*(.*)", lines.pop(0))
        if m: options[m[1]] = m[2].strip()
    return options, "\n".join(lines)


def pages():
    "Address on the site, and the notebook in the clone that it is made of"
    site = site_address()+"/"
    for nb in sorted(Path("nbs").rglob("*.ipynb")):
        page = re.sub(r"^\d+[a-zA-Z0-9]*_", "", nb.stem)+".html"
        yield site+nb.relative_to("nbs").with_name(page).as_posix(), nb.as_posix()


def in_clone(source, notebooks):
    "Markdown whose links begin at the top of the clone, and lead to notebooks"
    def moved(link):
        place, _, anchor = link[1].partition("#")
        if place in notebooks: place, anchor = notebooks[place], ""           # a notebook has no anchors on a git host
        elif "://" in place or not place: return link[0]
        else: place = f"nbs/{place}"
        if not Path(place).exists(): sys.exit(f"index.ipynb: a link leads to {place}, which is not there")
        return f"]({place}{'#' if anchor else ''}{anchor})"
    return re.sub(r"\]\(([^)\s]+)\)", moved, source)


def readme(index):
    "The README's text, from a processed index notebook"
    front, parts, notebooks = {}, [], dict(pages())
    for cell in json.loads(index.read_text())["cells"]:
        source = text(cell["source"])
        if cell["cell_type"] == "raw":
            if m := re.match(r"---\n(.*?)\n---", source, re.S): front.update(yaml.safe_load(m[1]) or {})
        elif cell["cell_type"] == "markdown": parts.append(in_clone(source, notebooks))
        else:
            options, code = split_options(source)
            if options.get("include") == "false": continue
            if options.get("echo") != "false" and code.strip(): parts.append(f"``` python\n{code}\n```")
            if options.get("output") == "false": continue
            for out in cell.get("outputs", []):
                data = out.get("data", {})
                if any(k.startswith("image/") for k in data): sys.exit("index.ipynb: no image outputs, please; link a picture in nbs/images")
                if "text/markdown" in data: parts.append(text(data["text/markdown"]))
                else: parts.append("```\n" + (text(out.get("text")) or text(data.get("text/plain"))).rstrip("\n") + "\n```")
    done = subprocess.run([pypandoc.get_pandoc_path(), "-f", READER, "-t", WRITER, "--default-image-extension=png"],
                          input="\n\n".join(parts), text=True, capture_output=True, check=True)
    return f"# {front['title']}\n\n\n{done.stdout}"


def main():
    with TemporaryDirectory() as folder:        # `proc_nbs` would do all notebooks, and takes minutes
        processed = Path(folder)/"index.ipynb"
        serve_drv.main((Path("nbs/index.ipynb"), processed, FilterDefaults))
        new = readme(processed)
    old = Path("README.md").read_text() if Path("README.md").exists() else ""
    if "--check" not in sys.argv:
        Path("README.md").write_text(new)
        return 0
    for line in difflib.unified_diff(old.splitlines(), new.splitlines(), "README.md", "from nbs/index.ipynb", lineterm=""): print(line)
    return int(old != new)


if __name__ == "__main__": sys.exit(main())
