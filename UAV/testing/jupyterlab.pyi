"For tests: a notebook in JupyterLab, in a browser without a screen, with the kernel that you want."
# Written by .ci/stubs.py from the live classes: do not edit.
import tempfile
from UAV.testing.browser import Browser
from pathlib import Path
from typing import Any
from typing_extensions import Self


class JupyterLab:
    "A JupyterLab server on the loopback address; ends with the `with`"
    programs: Path
    folder: tempfile.TemporaryDirectory
    port: int
    token: Any
    url: str
    process: Any
    def __init__(self, ipykernel: int) -> None:
        """
        Args:
            ipykernel: The version of its kernels, 6 or 7
        """
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "The server and its kernels end"

class LabPage:
    "A notebook in JupyterLab, whose kernel is ready"
    path: Any
    page: Any
    ask: Any
    def __init__(self, lab: JupyterLab, browser: Browser, cells: Any) -> None:
        """
        Args:
            lab: The server
            browser: Where it is opened
            cells: Source of each cell
        """
    def start(self, n: int) -> None:
        """Begin to run a cell

        Args:
            n: Number of the cell, from 0
        """
    def running(self, n: int) -> bool:
        "Does cell `n` run still?"
    def run(self, n: int) -> None:
        "Run cell `n`, and wait for its end; raises `TimeoutError`"
    def saved(self) -> dict:
        "Save the notebook, and read its file"
    def outputs(self, n: int) -> list:
        "What the saved notebook has below cell `n`"

__all__ = ['JupyterLab', 'LabPage']
