"""What this machine has for cells that begin with `#| gst` or `#| browser`."""
import subprocess, sys

NEEDS = dict(gst='from UAV.utils.gi import load_gst; load_gst()',            # what must work where such cells shall run
             browser='from UAV.testing.browser import find_chromium; find_chromium()')


def installed():
    "The flags whose cells can run here; why the others cannot is printed"
    for flag,try_it in NEEDS.items():
        tried = subprocess.run([sys.executable, '-c', try_it], capture_output=True, text=True)
        if tried.returncode == 0: yield flag
        else: print(f'skipped the cells that begin with `#| {flag}`:', *tried.stderr.splitlines()[-1:], flush=True)


def in_browser(notebook):
    "Whether `notebook` opens a browser: one at a time is enough for a small machine"
    return '"#| browser' in notebook.read_text(encoding='utf-8')


if __name__ == '__main__': sys.exit(not set(sys.argv[1:]) <= set(installed()))     # installed.py browser: 0 where it is
