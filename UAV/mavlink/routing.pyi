"Send each frame where its target was heard, pass frames on from link to link, and see how well the others are heard."
# Written by .ci/stubs.py from the live classes: do not edit.
from dataclasses import dataclass


@dataclass(frozen=True)
class LinkQuality:
    "How well a component is heard on a link"
    system: int
    component: int
    link: str
    received: int
    lost: int
    doubled: int
    round_trip: float | None
    @property
    def loss(self) -> float:
        "What part of its frames was lost, 0 to 1"
    @property
    def says(self) -> str:
        "All but the names, as text"
def what_to_ask(link: str) -> str:
    """What to ask when nothing comes by it

    Args:
        link: The name of a link
    """

__all__ = ['LinkQuality', 'what_to_ask']
