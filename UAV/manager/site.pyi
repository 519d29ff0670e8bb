"Answer what a browser asks of the panel: the page, the news, the buttons and the small pictures, without a socket."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.manager.http_limits import Door, Reply
from typing import Any

def after_of(text: str) -> dict:
    """`{camera id: number}`; raises `Refused` (400)

    Args:
        text: Such as '1/100:17,1/101:-1'
    """
def press_of(data: bytes) -> tuple:
    """`(what, of, args)`; raises `Refused` (400)

    Args:
        data: JSON: `{"do": …, "of": …, "args": {…}}`
    """
def page_html(title: str, token: str) -> str:
    """The page, as a browser gets it

    Args:
        title: Of the panel; any text
        token: One that needs no quoting
    """

class Site:
    "What the panel answers to a browser; all of it happens on the panel's loop"
    patience: float
    crowd: int
    gui: Any
    door: Door
    waiting: int
    files: dict
    def __init__(self, gui: Any, door: Door) -> None:
        """
        Args:
            gui: The `Gui`
            door: Who may come in
        """
    def admit(self, method: str, name: str, query: dict, headers: Any) -> None:
        """Raises `Refused` when this may not be answered

        Args:
            method: 'GET' or 'POST'
            name: The last part of the path
            query: From `query_of`
            headers: Of the request, as `http.server` reads them
        """
    async def answer(self, method: str, name: str, query: dict, data: bytes = b'') -> Reply:
        """Find the method for it; raises `Refused`

        Args:
            method: 'GET' or 'POST'
            name: The last part of the path
            query: From `query_of`
            data: The body of a POST
        """
    async def get_page(self, query: dict, data: bytes) -> Reply:
        "The page of the panel"
    async def get_poll(self, query: dict, data: bytes) -> Reply:
        "Status and pictures that the browser does not have yet; `X-Panel` tells the size of each"
    async def post_act(self, query: dict, data: bytes) -> Reply:
        "Press a button"
    async def get_status(self, query: dict, data: bytes) -> Reply:
        "The status of the panel, JSON"
    async def get_frame(self, query: dict, data: bytes) -> Reply:
        "A picture later than `after`, of camera `of` or the first one; 204 when none comes in time"
    async def get_thumbnail(self, query: dict, data: bytes) -> Reply:
        "A small picture of a photo: `of` camera, `key` from its status"
    def camera_of(self, query: dict) -> tuple:
        "`(row, path)` of a request for a file; raises `Refused` (400, 404)"
    async def get_files(self, query: dict, data: bytes) -> Reply:
        "What is in folder `path` of camera `of`"
    async def get_photo(self, query: dict, data: bytes) -> Reply:
        "A small picture of a file"
    async def get_download(self, query: dict, data: bytes) -> Reply:
        "A file, which is sent while it comes"

__all__ = ['after_of', 'press_of', 'page_html', 'Site']
