"A simulated world: flat ground with AprilTags at known places, and what a camera anywhere above it sees."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.cameras.lens import View
from collections.abc import Sequence
from functools import cached_property
from typing import Any

def wrapping_noise(seed: int, size: int) -> Any:
    """A square of noise of many sizes (float32, about -3..3), whose edges fit each other

    Args:
        seed: The same seed gives the same noise
        size: px
    """
def earth_palette() -> Any:
    "The colour of each of 256 heights: 256 x 3"
def draw_road(tile: Any) -> None:
    "A road from left to right, with a broken line in its middle"
def ground_tile(seed: int, size: int = 1024) -> Any:
    """Square BGR picture of grass and earth, with a crossing of two roads; its edges fit each other

    Args:
        seed: The same seed gives the same ground
        size: px
    """
def lying_tag(north: Any, east: Any, size: Any) -> list:
    "Corners of a tag on the ground; its upper edge is north"
def standing_tag(bearing: Any, distance: Any, size: Any) -> list:
    "Corners of a tag on a board that faces the origin from `bearing` (degrees) and `distance` (m)"

class SimWorld:
    "Flat ground with AprilTags at known places, a sky, and a car"
    tile_m: float
    car_radius: float
    car_speed: float
    haze: Sequence
    sky: Sequence
    family: str
    boards: range
    seed: int
    def __init__(self, seed: int = 0) -> None:
        """
        Args:
            seed: The same seed gives the same world
        """
    @cached_property
    def tile(self) -> Any:
        "The ground's texture, BGR, painted when it is first asked for"
    @cached_property
    def far_tile(self) -> Any:
        "The tile as it looks from afar: 64 x 64"
    @cached_property
    def tags(self) -> dict:
        "Corners (4 x 3, top left first and clockwise) of each tag, by its number"
    @cached_property
    def middles(self) -> tuple:
        "Number, middle and diagonal (m) of all tags, as arrays"
    def car(self, t: float) -> tuple:
        """North and east of the car, m, and where it heads, degrees

        Args:
            t: s
        """
    def background(self, view: View) -> Any:
        "Ground, haze and sky, a strip of rows at a time: most strips are only one of them"
    def visible_tags(self, view: View, smallest: float = 14.0) -> list:
        """Numbers of the tags that may be in the picture, the farthest first

        Args:
            view: From where
            smallest: Diagonal in px; smaller ones are left out
        """
    def car_box(self, view: View, t: float) -> tuple:
        "The rectangle around the car in a picture: left, top, right, bottom, px"
    def render(self, view: View, t: float = 0.0) -> Any:
        """The picture of the world: BGR, height x width x 3, uint8

        Args:
            view: From where
            t: s, for what moves
        """
sim_world: Any
def blend(upper: Any, lower: Any, weight: Any) -> Any:
    "`upper()` where `weight` (clipped to 0..1) is 1, `lower()` where it is 0; makes only what is seen"
plain: Any
def nearest_scale(length: float) -> int:
    "Pixels of the texture for each of a tag's 10 cells that are `length` px long together in the picture"
def bounding_box(pixels: Any, size: Any) -> tuple:
    "Left, top, right and bottom of the part of a picture of `size` that holds `pixels`"
def rim_of(corners: Any) -> Any:
    "Corners (4 x 3) of the white rim around a tag"

__all__ = [
    'wrapping_noise', 'earth_palette', 'draw_road', 'ground_tile', 'lying_tag', 'standing_tag', 'SimWorld',
    'sim_world', 'blend', 'plain', 'nearest_scale', 'bounding_box', 'rim_of',
]
