"`Visit` reads the requests of one browser and sends the answers, on a thread that never waits for long."
# Written by .ci/stubs.py from the live classes: do not edit.
import io
import threading
from UAV.manager.http_limits import Wire
from http.server import BaseHTTPRequestHandler
from logging import Logger
from typing import Any

log: Logger

class Visit(BaseHTTPRequestHandler):
    "One connection of a browser, on a thread of its own"
    protocol_version: str
    patience: float
    idle: float
    sending: float
    most_head: int
    server: Any
    connection: Any
    client_address: tuple
    trusted: bool
    busy: bool
    ended: bool
    future: Any
    since: Any
    wire: Wire
    rfile: io.BufferedReader
    wfile: io.BytesIO
    thread: threading.Thread
    close_connection: bool
    def __init__(self, server: Any, sock: Any, address: tuple) -> None:
        """
        Args:
            server: It has `site`, `closed`, the set `visits`, and `run` for coroutines
            sock: From `accept`
            address: Of the other side
        """
    def end(self) -> None:
        "Let its thread come to its end, from any thread"
    def handle_one_request(self) -> None:
        "Wait for a request, and answer it"
    def send_error(self, code: Any, message: Any = None, explain: Any = None) -> Any: ...
    def log_message(self, format: Any, *args: Any) -> None: ...
    def do_GET(self) -> None:
        "Answer a GET"
    def do_POST(self) -> None:
        "Answer a POST"
    def handle_expect_100(self) -> bool: ...

__all__ = ['log', 'Visit']
