"For tests: run a program of this package as you would type it, and see what it says and how it ends."
# Written by .ci/stubs.py from the live classes: do not edit.
import subprocess
from typing import Any


class Shell:
    "Types the words of one of our programs"
    patience: float
    program: Any
    at: tuple
    env: dict
    def __init__(self, program: str, *at: str, **env: Any) -> None:
        """
        Args:
            program: Such as 'uav-gimbal'
            at: Words that `says` and `fails` add, such as '--connection' and a link
            env: Environment variables
        """
    def start(self, *words: Any, **popen: Any) -> subprocess.Popen:
        "Start the program; its output and errors are pipes of text"
    def run(self, *words: Any) -> tuple:
        "Exit code, output and errors of one that ends by itself"
    def says(self, *words: Any, at: Any = None) -> None:
        "Run one that must succeed, and print what it says"
    def fails(self, code: int, *words: Any, at: Any = None) -> None:
        "Run one that must end with `code` and say nothing but errors, and print them"

__all__ = ['Shell']
