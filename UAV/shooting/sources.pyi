"Choose from a shell which eye of a camera is shown and which is in its corner, and see how hot it is in each stream."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.thermal import ThermalRange
from UAV.mavlink.video_client import Stream
from typing import Any

def view_text(stream: Stream, heat: ThermalRange | None) -> str:
    """What a stream shows, for people

    Args:
        stream: As the camera tells it
        heat: How hot it is there; `None`: not told
    """
def view_object(stream: Stream, heat: ThermalRange | None) -> dict:
    """The same for programs: °C, and where, as parts of the picture from its upper left corner

    Args:
        stream: As the camera tells it
        heat: How hot it is there; `None`: not told
    """
source_words: tuple
def source_word(text: str) -> str:
    "A type for `argparse`: an eye of the camera"
async def choose_source(shooting: Any, sources: list[Any]) -> None:
    """Choose which eye of the camera is shown, and which is in its corner; say what its streams show

    Args:
        sources: What is shown, and what is in its corner: rgb, ir, ndvi, default
    """

__all__ = ['source_words', 'view_text', 'view_object', 'source_word', 'choose_source']
