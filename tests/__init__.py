"""What only our own tests need: ground stations and autopilots played in pymavlink, a broken camera, Chromium, JupyterLab.
Not in the wheel. The notebooks of this folder export here: `python -c 'import tests; tests.export()'`"""
from pathlib import Path


def export():
    "Write the module of each notebook of this folder"
    from nbdev.export import nb_export
    folder = Path(__file__).parent
    for notebook in sorted(folder.glob('*.ipynb')): nb_export(notebook, lib_path=folder)
