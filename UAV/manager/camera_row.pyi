"`CameraRow` keeps all that the panel shows of one camera up to date, also when the camera tells nothing by itself."
# Written by .ci/stubs.py from the live classes: do not edit.
import asyncio
from UAV.manager.camera_actions import ZoomHelm
from UAV.manager.camera_files import Fetching
from UAV.manager.camera_told import CameraTold
from UAV.manager.gimbal_row import GimbalRow
from UAV.manager.preview import Preview
from UAV.manager.record_here import Keeper
from UAV.manager.rows import Row
from UAV.wire.dialect import Ack
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from typing import Any


class CameraRow(Row):
    "One camera: what it has told, its live picture, and its buttons"
    kind: str
    most: int
    watches: Sequence
    shows: dict
    hears: dict
    questions: dict
    longest: float
    listed: dict
    most_listed: int
    photos: dict
    photo_turn: asyncio.Lock | Any
    most_photos: int
    largest_photo: int
    settings: Any
    most_settings: int
    target_stays: float
    target_rate: float
    following: Any
    delay: float
    folder: str
    keeper: Keeper | Any
    patience: float
    client: Any
    target: tuple
    told: CameraTold
    preview: Preview
    due: dict
    tries: dict
    was_lost: bool
    ends: list
    thumbnails: dict
    streams: dict
    def __init__(self, gui: Any, target: tuple) -> None:
        """
        Args:
            gui: The `Gui`; its `camera_client` is on a link
            target: `(system, component)`
        """
    async def picture(self, after: int) -> tuple | None:
        "`(number, JPEG)` of the live picture, when it is later than `after`"
    async def close(self) -> None:
        "Leave the camera as it should be"
    def take(self, msg: Any) -> None:
        "Note what the camera tells; on the panel's loop"
    @contextmanager
    def listening(self) -> Generator[Any, None, None]:
        "For a `with`: take what the camera tells"
    def put_off(self, question: int) -> None:
        "Ask it later: after its period, and doubled each time that it was in vain"
    async def ask(self, question: int) -> None:
        "Ask the camera; what it answers is heard, as everything"
    def soon(self, *questions: Any) -> None:
        """Ask the camera these questions next; on the panel's loop

        Args:
            questions: Message ids; none: all
        """
    def ask_anew(self) -> None:
        "The camera was started again, or is back: ask it everything"
    @property
    def lost(self) -> str:
        "Why the camera is lost; empty when it is not"
    async def refresh(self) -> None:
        "Ask what was not told lately, unless the camera is lost"
    def on_picture(self, msg: Any) -> None:
        "A picture was taken"
    def thumbnail(self, key: int) -> bytes | None:
        """A small JPEG; `None`: it is gone

        Args:
            key: As in `status`
        """
    def on_information(self, msg: Any) -> None:
        "What it is; when it is another camera, all that the old one told is forgotten"
    def on_stream(self, msg: Any) -> None:
        "A stream; when all have come, they need not be asked for"
    async def run(self) -> None:
        "Listen, and ask; until cancelled"
    def aim(self) -> dict:
        "Which gimbal it is on, and whether a click can point it"
    def here(self) -> dict | None:
        "What we record of it: seconds, and the file; `None`: nothing"
    def status(self) -> dict:
        "All that a viewer shows of it, as plain values"
    async def snapshot(self) -> str:
        "Take a picture, and say which it is; raises `MAVError`"
    async def commanded(self, verb: Any, *questions: int) -> Ack:
        """Await the ack of a command, and ask the camera how it is

        Args:
            verb: A verb of the client, called
            questions: Message ids: what it is asked then
        """
    async def interval(self, seconds: float) -> Ack:
        """Take pictures until stopped

        Args:
            seconds: Between two pictures, .1 to 3600
        """
    async def stop_capture(self) -> Ack:
        "Take no more pictures"
    async def record(self, on: bool) -> Ack:
        """Have the camera record, on its own card

        Args:
            on: Start it, or stop it?
        """
    async def mode(self, mode: str) -> Ack:
        """Image, video or survey

        Args:
            mode: One of those that it has
        """
    async def zoom(self, percent: float) -> Ack:
        """Zoom to there

        Args:
            percent: 0 is wide, 100 as near as it can
        """
    async def zoom_step(self, step: int = 1) -> Ack:
        """Zoom a little

        Args:
            step: 1 is in, -1 is out
        """
    async def focus(self, percent: float) -> Ack:
        """Focus there

        Args:
            percent: 0 is the nearest, 100 is far away
        """
    async def autofocus(self) -> Ack:
        "Let the camera focus by itself"
    @property
    def zoomer(self) -> ZoomHelm:
        "What zooms while a button is held"
    async def zoom_hold(self, direction: float, hold: str, n: int) -> None:
        """A button is held, still: zoom. It ends by itself when this is not said again

        Args:
            direction: 1 is in, -1 is out
            hold: The same for as long as the button is down, and then never again
            n: Counts the words about it
        """
    async def zoom_release(self, hold: str) -> None:
        """The button was let go: zoom no more

        Args:
            hold: As for `zoom_hold`
        """
    async def show_stream(self, id: int) -> None:
        """Show this stream

        Args:
            id: As in `status`
        """
    async def files(self, path: str) -> dict:
        """`entries`: what is in it, the newest first, `most_listed` at most; `all`: how many there are; raises `MAVError`

        Args:
            path: A folder on the camera
        """
    async def photo(self, path: str) -> bytes:
        """A small JPEG of a picture on the camera; raises `ValueError` or `MAVError`

        Args:
            path: As in `files`
        """
    async def open_file(self, path: str) -> Fetching:
        """A file on its way; raises `ValueError` or `MAVError`

        Args:
            path: As in `files`
        """
    async def format(self) -> Ack:
        "Delete all that is on the camera's first storage"
    async def open_settings(self) -> str:
        "Ask the camera for its settings; raises `NoAnswer`"
    async def set_setting_of(self, name: str, value: Any) -> Ack:
        """Change a setting; raises `ValueError`, `NoAnswer`

        Args:
            name: Of the setting
            value: A number, or a text
        """
    async def reset_settings_of(self) -> Ack:
        "Put all settings back to their defaults"
    async def follow_target(self) -> None:
        "Have the camera tell where its target is, as long as it has one and a viewer looks"
    async def stop_following(self) -> None:
        "Follow no longer"
    async def track(self, left: float, top: float, right: float, bottom: float) -> Ack:
        """Follow what is in a rectangle

        Args:
            left, top, right, bottom: Parts of the picture, 0 to 1
        """
    async def untrack(self) -> Ack:
        "Follow nothing"
    def names(self, row: GimbalRow) -> bool:
        "Is it on this gimbal, as its CAMERA_INFORMATION says?"
    @property
    def gimbals(self) -> list:
        "The rows of gimbals that it may be on"
    @property
    def gimbal(self) -> GimbalRow | None:
        "The row of the gimbal that it is on; `None` when the panel has none, or cannot tell which"
    def field_of_view(self, msg: Any = None) -> tuple | None:
        """Horizontal and vertical field of view, degrees; `None` when they are not known

        Args:
            msg: A CAMERA_FOV_STATUS; `None`: the last one
        """
    @property
    def no_aim(self) -> str:
        "Why a click cannot point it; empty when it can"
    def held(self, number: int) -> tuple:
        """How the gimbal was held when a picture was taken, as a quaternion; raises `GimbalError` when that is not known

        Args:
            number: Of a picture
        """
    async def point(self, x: float, y: float, number: int) -> str:
        """Turn the gimbal so that what is there comes to the middle

        Args:
            x, y: Place in the picture, -1 to 1: right and down are positive
            number: Of the picture
        """
    async def stop_here(self) -> str | None:
        "End the recording; its name and length"
    async def record_here(self, on: bool) -> str | None:
        """Record what comes from the camera, on this computer; raises `MAVError`, `OSError` or `ValueError`

        Args:
            on: Start it, or stop it?
        """
    async def watch_keeper(self) -> None:
        "End a recording that has a fault, and say so in the log"
def hears(msg_id: int) -> Any:
    """Mark a function of a row and a message: what is done before a message of this kind is noted

    Args:
        msg_id: MAVLINK_MSG_ID
    """

__all__ = ['CameraRow', 'hears']
