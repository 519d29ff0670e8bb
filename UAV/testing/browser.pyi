"For tests: Chromium without a screen, and its pages as they look on a laptop and on a phone."
# Written by .ci/stubs.py from the live classes: do not edit.
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any
from typing_extensions import Self


class BrowserMissing(ImportError):
    "Chromium, its driver or selenium is not installed"
def find_chromium(path: str | None = None) -> tuple:
    """The system's Chromium and its `chromedriver`; raises `BrowserMissing`

    Args:
        path: Folders to look in, as in `PATH`; `None`: those of `PATH`
    """

class Browser:
    "Chromium without a screen; ends with the `with`; raises `BrowserMissing`"
    driver: Any
    pages: list
    def __init__(self) -> None: ...
    def __enter__(self) -> Self: ...
    def __exit__(self, *args: Any) -> None: ...
    def close(self) -> None:
        "All pages close, and the browser ends"
    def open(self, url: str, size: tuple = ..., dark: bool = False, touch: bool = False) -> Page:
        """A page with `url`, in a window of its own

        Args:
            url: Of the page
            size: See `Page.look`
            dark: See `Page.look`
            touch: See `Page.look`
        """
    def complaints(self) -> list:
        "What the console has said of errors and warnings since it was asked last"

class Page:
    "One page of a `Browser`, in a window of its own"
    held: tuple | Any
    browser: Browser
    handle: str
    def __init__(self, browser: Browser, handle: str) -> None: ...
    @property
    def driver(self) -> Any:
        "The browser's driver, which looks at this page now"
    def js(self, script: str, *args: Any) -> Any:
        """What `script` returns in this page

        Args:
            script: A function's body: it says `return` when it has an answer
            args: Its `arguments`
        """
    def cdp(self, command: str, **args: Any) -> Any:
        """The answer to a command of the Chrome DevTools Protocol

        Args:
            command: Of Chromium's own protocol, for example 'Page.bringToFront'
            args: What it wants
        """
    def look(self, size: tuple = ..., dark: bool = False, touch: bool = False) -> None:
        """Show this page on another device

        Args:
            size: Width and height in CSS pixels: `laptop`, `phone`, or your own
            dark: Does the system prefer dark pages?
            touch: Has it a touch screen in place of a mouse?
        """
    def until(self, question: Any, timeout: float = 10.0, what: str = '') -> Any:
        """The first answer of `question` that is true; raises `TimeoutError`

        Args:
            question: A JavaScript expression, or a function without arguments
            timeout: Seconds to wait at most
            what: The question in words, for the error
        """
    def text(self, css: str) -> str:
        """The visible text of the first element that `css` selects; raises selenium's `NoSuchElementException`

        Args:
            css: Selects the element
        """
    def count(self, css: str) -> int:
        "How many visible elements `css` selects"
    def screenshot(self) -> Any:
        "What this page shows"
    def pixels(self, css: str = 'img') -> Any:
        """The picture that an `<img>` holds

        Args:
            css: Selects an `<img>`
        """
    def close(self) -> None:
        "Close this page; may be called twice. A browser needs one page that stays"
    def place(self, css: str, x: float = 0.0, y: float = 0.0) -> tuple:
        """Where on this page that place in the element is, after scrolling there

        Args:
            css: Selects the element
            x: From −1 (left) to 1 (right)
            y: From −1 (top) to 1 (bottom)
        """
    def press(self, css: str, x: float = 0.0, y: float = 0.0, touch: bool = False) -> None:
        "Put the mouse button, or with `touch` a finger, down at a `place`"
    def let_go(self) -> None:
        "Take it up again, if it is down"
    @contextmanager
    def pressed(self, css: str, x: float = 0.0, y: float = 0.0, touch: bool = False) -> Generator[Any, None, None]:
        "The same as long as the `with` lasts"
    def click(self, css: str, x: float = 0.0, y: float = 0.0, touch: bool = False) -> None:
        "Press and release the mouse, or with `touch` a finger, at a `place`"
    def cancel(self) -> None:
        "The system takes the finger away that is down"
    def key(self, name: str, what: str = 'Down') -> None:
        """One end of a keystroke, to the element that has the focus

        Args:
            name: As JavaScript calls it: 'ArrowLeft', 'Tab', 'r', ' '
            what: 'Down' or 'Up'; a key that is down and goes down again repeats
        """
    @contextmanager
    def key_held(self, name: str) -> Generator[Any, None, None]:
        "Hold a key down as long as the `with` lasts"
    def type(self, name: str) -> None:
        "Press a key and let it go"
    def hide(self) -> None:
        "Minimise the window"
    def show(self) -> None:
        "The window is there again"
    def offline(self, gone: bool = True) -> None:
        """Take the network from this page; what it has asked for ends with an error

        Args:
            gone: `False`: it is back
        """
laptop: tuple
phone: tuple

__all__ = ['laptop', 'phone', 'BrowserMissing', 'find_chromium', 'Browser', 'Page']
