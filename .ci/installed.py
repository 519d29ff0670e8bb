"""What this machine has for cells that begin with `#| gst`, `#| browser`, `#| firefox`, `#| axe` or `#| webrtc`."""
import subprocess, sys

GST = """
from UAV.cameras.gst_pipeline import _package_of
from UAV.cameras.gst_pipeline import load_gst
find = load_gst().ElementFactory.find
for name in 'videotestsrc videobalance x264enc h264parse avdec_h264'.split():        # one of each package
    if not find(name): raise ImportError(f'no element {name!r}: it comes with {_package_of(name)}')
"""
BROWSER = 'import selenium; from tests.browser import find_chromium; find_chromium()'
FIREFOX = 'import websocket; from tests.browser import find_firefox; find_firefox()'
AXE = 'from tests.browser import axe_source; axe_source()'
WEBRTC = 'import aiortc'
NEEDS = dict(gst=GST, browser=BROWSER, firefox=FIREFOX, axe=AXE, webrtc=WEBRTC)      # what must work where such cells shall run


def installed():
    "The flags whose cells can run here; why the others cannot is printed"
    for flag,try_it in NEEDS.items():
        tried = subprocess.run([sys.executable, '-c', try_it], capture_output=True, text=True)
        if tried.returncode == 0: yield flag
        else: print(f'skipped the cells that begin with `#| {flag}`:', *tried.stderr.splitlines()[-1:], flush=True)


def in_browser(notebook):
    "Whether `notebook` opens a browser: one at a time is enough for a small machine"
    text = notebook.read_text(encoding='utf-8')
    return '"#| browser' in text or '"#| firefox' in text


if __name__ == '__main__': sys.exit(not set(sys.argv[1:]) <= set(installed()))     # installed.py browser: 0 where it is
