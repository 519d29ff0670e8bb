"Find the cameras, choose the one that you mean, and describe it in a sentence or as JSON."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.mavlink.camera_client import CameraClient
from UAV.steering.visit import Program, Visit, Visitor
from collections.abc import AsyncGenerator, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


class Shooting(Visit):
    "A camera, and what was typed about it"
    program: str
    kind: str
    told_by_itself: dict
    beginning: float
    async def first_sign(self, seconds: float) -> bool | None:
        "Is there a camera at the address that was typed? `None`: nothing came in time"
    async def look(self, count: int | None, seconds: float) -> list:
        "The cameras that are heard; raises `NoAnswer` when the one that was typed is none"
    def called(self, camera: Any) -> str:
        "What tells a camera from another"
    def tell(self, sentence: str, **fields: Any) -> None:
        """Say something about the camera that was chosen

        Args:
            sentence: For people
            fields: The same for programs
        """
    def others(self, cameras: list) -> list:
        "The components that were heard and are none of these `cameras`"
    async def tell_status(self, name: str = '') -> None:
        "Say how the camera is; raises `NoAnswer` when it says nothing"
    @contextmanager
    def hearing(self, msg_ids: Any, put: Any) -> Generator[Any, None, None]:
        """For a `with`: hear what the camera tells

        Args:
            msg_ids: Of the messages
            put: Called with each of them that comes from the camera, on the event loop
        """
    def news(self) -> AsyncGenerator[Any, None]:
        "For `async for`: `(message name, text, fields)` of what the camera tells. Raises `Lost`"
    async def fetch(self, path: str, folder: Any) -> Path:
        """The file, which is here now; raises `ValueError`, `OSError` or `MAVError`

        Args:
            path: On the camera, or a `mftp://` URL
            folder: Where to, as for `folder_here`
        """
    async def tell_picture(self, msg: Any, folder: Any = None) -> None:
        """Say that a picture was taken, and fetch it if it is wanted here

        Args:
            msg: A CAMERA_IMAGE_CAPTURED
            folder: Where its file is to go
        """
    async def recorded(self, seconds: float) -> None:
        "Wait while the camera records; raises `NotTaken` when it ends by itself"
    async def begin_recording(self, stream: int, frequency: float) -> None:
        "Have the camera record; raises `CommandError` or `NoAnswer`"
    async def tell_settings(self) -> None:
        "Say mode, zoom and focus as the camera tells them; raises `NoAnswer`"
    async def move(self, verb: Any, kind: int, speed: float, seconds: float) -> None:
        """Move the lens for some time; raises what `Ack.check` raises

        Args:
            verb: `set_camera_zoom` or `set_camera_focus` of the client
            kind: Its number for moving all the time
            speed: -1 to 1
            seconds: How long
        """
    async def tell_views(self) -> None:
        "Say what each stream shows; raises `NoAnswer`, or `MAVError` when there is no stream"
    async def tell_target(self) -> None:
        "Say what the camera tracks; raises `NoAnswer`"
    async def known_settings(self) -> dict:
        "`{name: Parameter}`; `{name: None}` for a camera without a definition. Raises `NoAnswer`"
    async def tell_files(self, path: str) -> None:
        "Say which files a folder of the camera has"
    async def meant_files(self, path: str) -> list:
        "Paths of the files that are meant by one: itself, or what is in the folder"
    async def bring(self, path: str, folder: str) -> None:
        "Fetch one file, and say where it is now"

class CameraVisitor(Visitor, CameraClient):
    "A client that is there for a moment, again and again"
def camera_options(
        connection: str = 'udpin:0.0.0.0:14550', system: Any = None, component: Any = None, timeout: Any = 5.0,
        sign: str | None = None, json: bool = False,
) -> Any:
    """What all verbs have

    Args:
        connection: MAVLink links, with commas between them
        system: System id of the camera; needed when there are several
        component: Component id of the camera
        timeout: s to look for a camera; an answer may take up to 10 s
        sign: File with the key of a signed link
        json: Say everything as JSON, one object a line
    """
about_program: str
camera_program: Program

__all__ = ['about_program', 'camera_program', 'Shooting', 'CameraVisitor', 'camera_options']
