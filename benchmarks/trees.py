"""Which code is measured: the checkout named by `UAV_TREE`, or else the one these files lie in."""
import importlib, os, sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
TREE = Path(os.environ.get('UAV_TREE') or HERE.parent).resolve()
sys.path.insert(0, str(TREE))

ROOMS = dict(FrameReader=('wire.reader','wire.frames','mavlink.frames'), Wanted=('wire.reader','wire.frames','mavlink.frames'),
             LossyLink=('wire.lossy','mavlink.lossy'), command=('mavlink.handlers','mavlink.protocol'))

def ours(name):
    "What is called `name`, from the room where this checkout has it"
    room = next(r for r in ROOMS[name] if (TREE/'UAV'/f"{r.replace('.', '/')}.py").exists())
    return getattr(importlib.import_module(f'UAV.{room}'), name)

def environment(tree=None):
    "The environment of a process that measures `tree`; `None`: what we measure ourselves"
    return dict(os.environ, UAV_TREE=str(Path(tree).resolve() if tree else TREE), MAVLINK20='1')
