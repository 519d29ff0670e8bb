"""What the MAVSDK programs of this folder share: a ground station that takes a picture with each camera, and fetches it."""
import queue, re, time
from collections import defaultdict
from pathlib import Path

from mavsdk import ComponentType, Configuration, Mavsdk, log_subscribe
from mavsdk.plugins.camera import Camera
from mavsdk.plugins.ftp import Ftp, FtpResult


class Station:
    def __init__(self, connection, timeout=10):
        log_subscribe(lambda *_: True)
        self.sdk = Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
        self.sdk.add_any_connection_with_handle(connection)
        systems = queue.Queue()
        self.sdk.subscribe_on_new_system(lambda *_: systems.put(True))
        if not self.sdk.get_systems(): systems.get(timeout=timeout)
        self.system = self.sdk.get_systems()[0]
        self.camera, self.ftp = Camera(self.system), Ftp(self.system)
        self.lists, self.shots = queue.Queue(), defaultdict(queue.Queue)
        self.camera.subscribe_camera_list(lambda found, _: self.lists.put(found.cameras))
        self.camera.subscribe_capture_info(lambda shot, _: self.shots[shot.component_id].put(shot))

    def __enter__(self): return self
    def __exit__(self, *_):
        for plugin in (self.ftp, self.camera, self.sdk): plugin.destroy()

    def cameras(self, count, timeout=10):
        "The cameras that are listed within so many seconds, at most `count`"
        found, end = self.camera.camera_list().cameras, time.monotonic()+timeout
        try:
            while len(found) < count: found = self.lists.get(timeout=max(end-time.monotonic(), 0))
        except queue.Empty: pass
        return found

    def shoot(self, component):
        self.camera.take_photo(component)           # raises CameraError
        shot = self.shots[component].get(timeout=10)
        if not shot.is_success: raise RuntimeError(f'camera {component} could not take the picture')
        return shot

    def fetch(self, component, shot, folder):
        "One file at a time: the plugin has one target"
        folder.mkdir(parents=True, exist_ok=True)
        path, done = re.sub(r'^mftp://(\[.*?\])?', '', shot.file_url), queue.Queue()
        file = folder/Path(path).name
        self.ftp.set_target_compid(component)
        self.ftp.download_async(path, str(folder), True, lambda result, *_: result != FtpResult.NEXT and done.put(result))
        if (result := done.get(timeout=60)) != FtpResult.SUCCESS: raise RuntimeError(f'{path}: {result.name}')
        if not self.ftp.are_files_identical(str(file), path): raise RuntimeError(f'{path} came with errors')
        return file
