"""What only our own tests need: ground stations and autopilots played in pymavlink, a broken camera, Chromium, JupyterLab.
Not in the wheel. The notebooks of this folder export here: `python -c 'import tests; tests.export()'`"""
from configparser import ConfigParser
from pathlib import Path


def settings():
    "What stands in settings.ini"
    parser = ConfigParser(delimiters=['='])
    parser.read(Path(__file__).parents[1]/'settings.ini', encoding='utf-8')
    return parser['DEFAULT']


def export():
    "Write the module of each notebook of this folder"
    from nbdev.export import nb_export
    folder = Path(__file__).parent
    for notebook in sorted(folder.glob('*.ipynb')): nb_export(notebook, lib_path=folder)


def in_main_thread(cells=()):
    "nbdev's `test_setup`: cells run in the main thread, which handlers of signals and `asyncio.run` need; execnb has another for them"
    import nbdev.test, signal
    from execnb.shell import CaptureShell, _out_nb

    def run(self, code, stdout=True, stderr=True, timeout=None, verbose=False, grace=5):
        if self._thread.is_alive(): self.close()
        done = self._run(code, store_history=True, stdout=stdout, stderr=stderr, verbose=verbose)
        self.result,self.exc = done.result.result,done.exception
        return _out_nb(done, self.display_formatter)

    CaptureShell.run,nbdev.test._int_handler = run,signal.default_int_handler
