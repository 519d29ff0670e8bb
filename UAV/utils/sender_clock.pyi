"Convert the times in a sender's messages to our own clock."
# Written by .ci/stubs.py from the live classes: do not edit.


class SenderClock:
    "Translates moments of a sender's clock into ours"
    window: float
    piece: float
    late: float
    still: float
    def __init__(self) -> None: ...
    @property
    def difference(self) -> float:
        "s that our clock is ahead of the sender's, and of what the least delayed message needed"
    def ours(self, told: float, arrived: float) -> float:
        """When the message was made, s on our clock; it is never later than `arrived`

        Args:
            told: When the message was made, s on the sender's clock
            arrived: When it came, s on ours
        """

__all__ = ['SenderClock']
