#!/usr/bin/env python3
"""Write README.md from nbs/index.ipynb as `nbdev_readme` does, without needing Quarto.

Usage, from the project's root, in its development environment:
    python .ci/readme.py [--check]
With --check nothing is written; exit status 1 when README.md differs from what the notebook gives.
"""
import difflib, json, re, subprocess, sys
from pathlib import Path
import pypandoc, yaml
from nbdev.quarto import refresh_quarto_yml
from nbdev.serve import proc_nbs

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


def readme(index):
    "The README's text, from a processed index notebook"
    front, parts = {}, []
    for cell in json.loads(index.read_text())["cells"]:
        source = text(cell["source"])
        if cell["cell_type"] == "raw":
            if m := re.match(r"---\n(.*?)\n---", source, re.S): front.update(yaml.safe_load(m[1]) or {})
        elif cell["cell_type"] == "markdown": parts.append(source)
        else:
            options, code = split_options(source)
            if options.get("include") == "false": continue
            if options.get("echo") != "false" and code.strip(): parts.append(f"``` python\n{code}\n```")
            if options.get("output") == "false": continue
            for out in cell.get("outputs", []):
                data = out.get("data", {})
                if any(k.startswith("image/") for k in data): sys.exit("index.ipynb: no image outputs, please; link a picture by its absolute URL")
                if "text/markdown" in data: parts.append(text(data["text/markdown"]))
                else: parts.append("```\n" + (text(out.get("text")) or text(data.get("text/plain"))).rstrip("\n") + "\n```")
    done = subprocess.run([pypandoc.get_pandoc_path(), "-f", READER, "-t", WRITER, "--default-image-extension=png"],
                          input="\n\n".join(parts), text=True, capture_output=True, check=True)
    return f"# {front['title']}\n\n\n{done.stdout}"


def main():
    refresh_quarto_yml()
    proc_nbs(n_workers=0, force=True)
    new, old = readme(Path("_proc/index.ipynb")), Path("README.md").read_text() if Path("README.md").exists() else ""
    if "--check" not in sys.argv:
        Path("README.md").write_text(new)
        return 0
    for line in difflib.unified_diff(old.splitlines(), new.splitlines(), "README.md", "from nbs/index.ipynb", lineterm=""): print(line)
    return int(old != new)


if __name__ == "__main__": sys.exit(main())
