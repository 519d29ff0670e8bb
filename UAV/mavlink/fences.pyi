"Keep a late ack of one command from being taken for the answer to the next: a question in between shows that all acks have come."
# Written by .ci/stubs.py from the live classes: do not edit.
from logging import Logger

fence_tries: int

class Fence:
    "A question whose answer shows that all answers to earlier ones have come"
    def __init__(self) -> None: ...
log: Logger
busy: float

__all__ = ['fence_tries', 'log', 'busy', 'Fence']
