"""Which code is measured: the checkout named by `UAV_TREE`, or else the one these files lie in."""
import importlib, os, sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TREE = Path(os.environ.get('UAV_TREE') or HERE.parent).resolve()
sys.path.insert(0, str(TREE))

def wire(room):
    "A room of the wire, for example `links`; an older checkout has it in UAV.mavlink"
    tower = 'wire' if (TREE/'UAV'/'wire').is_dir() else 'mavlink'
    return importlib.import_module(f'UAV.{tower}.{room}')

def environment(tree=None):
    "The environment of a process that measures `tree`; `None`: what we measure ourselves"
    return dict(os.environ, UAV_TREE=str(Path(tree).resolve() if tree else TREE), MAVLINK20='1')
