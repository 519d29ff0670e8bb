#!/usr/bin/env python3
"""Make the moving pictures of the front page, nbs/images/*.webp, from real runs of the package.

Usage, from the project's root, in its development environment:
    python .ci/gallery.py [gimbal] [panel] [track] [survey]
Without names it makes all four, in about two minutes; `panel` needs Chromium. Vehicle, gimbal and camera are simulated;
commands, notices, tracker, panel and files are those that a real vehicle meets. Run it when the look of one has changed.
"""
import asyncio, math, sys, time
from contextlib import ExitStack
from pathlib import Path
import cv2, numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import get_data_path

from UAV.cameras import SimCamera
from UAV.cameras.lens import View
from UAV.flying.sim import sim_vehicle
from UAV.gimbals import SimGimbal, SimVehicle, circle, strips
from UAV.manager import Gui
from UAV.mavlink import CameraClient, CameraServer, GimbalClient, GimbalServer, MAVCom, SimAutopilot, mavlink
from UAV.mavlink.camera_fov import field_of_view, footprint
from UAV.testing import Browser, TruthCamera, free_port
from UAV.utils.earth import metres

SIZE, BAR = (400, 300), 28          # px: a picture, and the title over it
FOLDER = Path(__file__).parent.parent/"nbs/images"
FONT = ImageFont.truetype(f"{get_data_path()}/fonts/ttf/DejaVuSans.ttf", 15)


def titled(image, title):
    "A BGR picture as one of the gallery, with a bar that says what is seen"
    sheet = Image.new("RGB", (SIZE[0], SIZE[1]+BAR), "#1f2933")
    ImageDraw.Draw(sheet).text((10, BAR/2), title, fill="#f1f3f5", font=FONT, anchor="lm")
    sheet.paste(Image.fromarray(cv2.cvtColor(cv2.resize(image, SIZE, interpolation=cv2.INTER_AREA), cv2.COLOR_BGR2RGB)), (0, BAR))
    return sheet


def save(name, images, titles, rate, rest=0, quality=45):
    "Write `nbs/images/NAME.webp`: so many pictures a second; it rests at the last one for `rest` s"
    first, *others = (titled(image, title) for image, title in zip(images, titles))
    durations = [round(1000/rate)]*len(images)
    durations[-1] += round(1000*rest)
    file = FOLDER/f"{name}.webp"
    first.save(file, save_all=True, append_images=others, duration=durations, loop=0, quality=quality, method=6, minimize_size=False)
    print(f"{file.name}: {len(images)} pictures, {file.stat().st_size/1000:.0f} kB")


def aircraft_with(stack, link, vehicle, gimbal, camera):
    "The three on board, served on `link`; a client of the camera and one of the gimbal, on the ground"
    on_board, ground = stack.enter_context(MAVCom(link, source_system=1)), stack.enter_context(MAVCom(link))
    for component in (CameraServer(camera=camera), GimbalServer(gimbal=gimbal), SimAutopilot(vehicle)): on_board.add_component(component)
    client, pilot = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER)), ground.add_component(GimbalClient(mavlink.MAV_COMP_ID_USER1))
    client.set_target(1, mavlink.MAV_COMP_ID_CAMERA)
    return client, pilot


async def gimbal():
    "The vehicle flies a circle; the gimbal is told where to look"
    images, titles = [], []
    vehicle = SimVehicle(circle(radius=40, speed=5, altitude=40))
    with ExitStack() as stack:
        turned = SimGimbal(vehicle)
        camera = SimCamera(*SIZE, mount=turned)
        _, pilot = aircraft_with(stack, "virtual:gallery_gimbal", vehicle, turned, camera)
        for thing in (turned, camera): stack.callback(thing.close)
        await pilot.wait_ready()
        async with pilot.control():
            for pitch, yaw in ((-20, 0), (-20, 70), (-60, 70), (-35, -40), (-20, 0)):
                ack = await pilot.set_angles(pitch=pitch, yaw=yaw)
                assert ack, ack
                for _ in range(11):
                    images.append(camera.read().image)
                    titles.append(f"uav-gimbal angle {pitch} {yaw}")
                    await asyncio.sleep(.16)
    save("gallery_gimbal", images, titles, rate=6, quality=40)


async def panel():
    "A mouse presses what you would press"
    images, titles = [], []
    link = "virtual:gallery_panel"
    with ExitStack() as stack:
        stack.enter_context(sim_vehicle([link], rate=10))
        ground = stack.enter_context(MAVCom(link, source_system=253))
        clients = CameraClient(mavlink.MAV_COMP_ID_USER1), GimbalClient(mavlink.MAV_COMP_ID_MISSIONPLANNER)
        gui = stack.enter_context(Gui(*(ground.add_component(client) for client in clients), title="A simulated vehicle"))
        server = gui.serve(port=free_port())
        page = stack.enter_context(Browser()).open(server.url, size=(680, 510))
        page.until('/live [1-9]/.test(document.querySelector(".picture")?.textContent)', timeout=60)

        def look(title, count, finger=None):
            for _ in range(count):
                shot = page.screenshot()
                if finger: cv2.circle(shot, tuple(int(n) for n in page.place(".pad", *finger)), 16, (0, 140, 255), 4)
                images.append(shot)
                titles.append(title)
                time.sleep(.1)

        look("uav-gui --sim --browser", 3)
        for x, y in ((.6, 0), (0, .6)):
            with page.pressed(".pad", x=x, y=y): look("press and hold: the gimbal turns", 8, (x, y))
        look("let go: it stands still", 4)
        page.click("button[data-do=snapshot]")
        look("and take a picture", 5)
    save("gallery_panel", images, titles, rate=5, rest=1, quality=45)


async def track():
    "A gimbal that follows a car, by what the camera's tracker says"
    shots = []
    vehicle = SimVehicle(circle(radius=100, speed=4, altitude=40, middle=(-100, 0)))
    with ExitStack() as stack:
        turned = SimGimbal(vehicle)
        camera = TruthCamera(mount=turned, car_speed=3)
        client, pilot = aircraft_with(stack, "virtual:gallery_track", vehicle, turned, camera)
        for thing in (turned, camera): stack.callback(thing.close)
        await pilot.wait_ready()
        size = np.array([camera.lens.horizontal_fov, -camera.lens.horizontal_fov*.75])
        async with pilot.control():
            lat, lon, alt = vehicle.on_earth(*camera.world.car(camera.number/camera.frame_rate)[:2], 0)
            await pilot.point_at(lat, lon, alt, alt_frame="amsl")
            await asyncio.sleep(2)
            await client.camera_track_rectangle(**camera.around_car())
            keeping_up = np.zeros(2)
            async for status in client.tracking_updates(rate=10):
                if len(shots) == 100 or status.status == "idle": break
                if status.point is None: continue
                off = (np.array(status.point)-.5)*size
                keeping_up += off/40
                yaw, pitch = off+keeping_up
                await pilot.set_rates(pitch=pitch, yaw=yaw)
                shots.append(camera.tracking.status)

    def drawn(status):
        image = cv2.resize(status.frame.image, SIZE, interpolation=cv2.INTER_AREA)
        if status.rectangle is None: return image
        left, top, right, bottom = (round(n*size) for n, size in zip(status.rectangle, SIZE*2))
        return cv2.rectangle(image, (left-4, top-4), (right+4, bottom+4), (0, 255, 255), 2)

    save("gallery_track", [drawn(s) for s in shots[::2]], ["the camera tracks, the gimbal follows"]*len(shots), rate=6, quality=40)


async def survey():
    "Pictures every 12 m, laid on the ground where their files say that they were taken"
    vehicle = SimVehicle(strips(count=4, length=96, apart=18, speed=20, altitude=40, start=(-48, -27)), heading=0)
    vehicle.began = math.inf

    class Below:
        def look(self):
            north, east, up = vehicle.position()
            return north, east, up, 0., -90., vehicle.yaw()

    with ExitStack() as stack:
        camera = SimCamera(mount=Below())
        stack.callback(camera.close)
        on_board, ground = (stack.enter_context(MAVCom("virtual:gallery_survey", source_system=n)) for n in (1, 255))
        on_board.add_component(server := CameraServer(camera=camera))
        client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER))
        client.set_target(1, mavlink.MAV_COMP_ID_CAMERA)
        position = mavlink.MAVLINK_MSG_ID_GLOBAL_POSITION_INT
        with client.expecting(position) as first, server.expecting(position) as there:
            on_board.add_component(SimAutopilot(vehicle))
            assert await first.wait(20) and await there.wait(20)
        ack = await client.do_set_cam_trigg_dist(distance=12, trigger=True)
        assert ack, ack
        vehicle.began = vehicle.clock()
        end = vehicle.path(1e6)
        while vehicle.position() != end: await asyncio.sleep(.1)
        await client.do_set_cam_trigg_dist(distance=0)
        assert camera.wait_idle(30)
        fov, home = field_of_view(camera), vehicle.origin[:2]
        taken = [(cv2.imread(str(camera.storage.folder/p.file)), p) for p in camera.pictures if p.ok]

    def spot(north, east): return SIZE[0]/2+north*2.9, SIZE[1]/2+east*2.9       # north is to the right; 2.9 px are a metre

    ground_map, places, images, titles = np.full((SIZE[1], SIZE[0], 3), 245, np.uint8), [], [], []
    for number, (image, picture) in enumerate(taken, 1):
        pose = picture.pose
        corners = np.float32([spot(*metres(*home, *corner[:2])) for corner in footprint(pose, fov)])
        height, width = image.shape[:2]
        onto = cv2.getPerspectiveTransform(np.float32([(0, 0), (width, 0), (width, height), (0, height)]), corners)
        laid = cv2.warpPerspective(image, onto, SIZE, flags=cv2.INTER_AREA)
        mask = np.zeros((height, width), np.uint8)
        mask[3:-20, 3:-3] = 255             # without its edges and without the name that the camera writes at the bottom
        mask = cv2.warpPerspective(mask, onto, SIZE)
        ground_map[mask > 127] = laid[mask > 127]
        places.append(spot(*metres(*home, pose.lat, pose.lon)))
        shown = ground_map.copy()
        cv2.polylines(shown, [np.int32(places)], False, (255, 255, 255), 1, cv2.LINE_AA)
        for place in places: cv2.circle(shown, tuple(int(n) for n in place), 3, (12, 89, 232), -1, cv2.LINE_AA)
        cv2.polylines(shown, [np.int32(corners)], True, (255, 255, 255), 2, cv2.LINE_AA)
        images.append(shown)
        titles.append(f"a picture every 12 m: number {number}")
    save("gallery_survey", images, titles, rate=4, rest=2, quality=45)


if __name__ == "__main__":
    makers = dict(gimbal=gimbal, panel=panel, track=track, survey=survey)
    for name in sys.argv[1:] or makers: asyncio.run(makers[name]())
