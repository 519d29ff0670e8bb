#!/usr/bin/env python3
"""Make the moving pictures of the front page and the still ones of the panel, nbs/images/*.webp, from real runs of the package.

Usage, from the project's root, in its development environment:
    python .ci/gallery.py [gimbal] [panel] [track] [survey] [screens]
Without names it makes all, in about three minutes; `panel` and `screens` need Chromium. Vehicle, gimbal and camera are simulated;
commands, notices, tracker, panel and files are those that a real vehicle meets. Run it when the look of one has changed.
"""
import asyncio, math, sys, time
from base64 import b64decode
from contextlib import ExitStack
from pathlib import Path
import cv2, numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import get_data_path

from UAV.cameras import SimCamera
from UAV.cameras.sim import find_tags
from UAV.cli.gui import sim_vehicle
from UAV.gimbals import SimGimbal, SimVehicle, circle, strips
from UAV.manager import Gui
from UAV.mavlink import CameraClient, CameraServer, GimbalClient, GimbalServer, MAVCom, SimAutopilot, mavlink
from UAV.mavlink.camera_tracking import field_of_view, footprint
from tests.browser import Browser
from UAV.testing import TruthCamera, free_port
from UAV.utils.geo import metres

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


async def aircraft_with(stack, link, vehicle, gimbal, camera):
    "The three on board, served on `link`; a client of the camera and the handle of the gimbal, on the ground"
    on_board, ground = stack.enter_context(MAVCom(link, source_system=1)), stack.enter_context(MAVCom(link))
    for component in (CameraServer(camera=camera), GimbalServer(gimbal=gimbal), SimAutopilot(vehicle)): on_board.add_component(component)
    client = ground.add_component(CameraClient(mavlink.MAV_COMP_ID_MISSIONPLANNER))
    client.set_target(1, mavlink.MAV_COMP_ID_CAMERA)
    return client, await (await ground.find_gimbal()).wait_ready()


async def gimbal():
    "The vehicle flies a circle; the gimbal is told where to look"
    images, titles = [], []
    vehicle = SimVehicle(circle(radius=40, speed=5, altitude=40))
    with ExitStack() as stack:
        turned = SimGimbal(vehicle)
        camera = SimCamera(*SIZE, mount=turned)
        _, pilot = await aircraft_with(stack, "virtual:gallery_gimbal", vehicle, turned, camera)
        for thing in (turned, camera): stack.callback(thing.close)
        async with pilot.control():
            for pitch, yaw in ((-20, 0), (-20, 70), (-60, 70), (-35, -40), (-20, 0)):
                ack = await pilot.set_angles(pitch=pitch, yaw=yaw)
                assert ack, ack
                for _ in range(11):
                    images.append(camera.read().image)
                    titles.append(f"uav-gimbal angle {pitch} {yaw}")
                    await asyncio.sleep(.16)
    save("gallery_gimbal", images, titles, rate=6, quality=40)


def panel_of(stack, *links, title="A simulated vehicle"):
    "A panel on these links: its `Gui`, and the address of its page"
    ground = stack.enter_context(MAVCom(*links, source_system=253))
    clients = CameraClient(mavlink.MAV_COMP_ID_USER1), GimbalClient(mavlink.MAV_COMP_ID_MISSIONPLANNER)
    gui = stack.enter_context(Gui(*(ground.add_component(client) for client in clients), title=title))
    return gui, gui.serve(port=free_port()).url


LIVE = '/Live [1-9]/.test(document.querySelector(".picture")?.textContent)'


def quick(page):
    "What the page shows, as JPEG: the page has time to say that a button is held"
    jpeg = b64decode(page.cdp("Page.captureScreenshot", format="jpeg", quality=92, optimizeForSpeed=True)["data"])
    return cv2.imdecode(np.frombuffer(jpeg, np.uint8), cv2.IMREAD_COLOR)


async def panel():
    "A mouse presses what you would press"
    images, titles = [], []
    with ExitStack() as stack:
        stack.enter_context(sim_vehicle(["virtual:gallery_panel"], rate=10))
        gui, url = panel_of(stack, "virtual:gallery_panel")
        page = stack.enter_context(Browser()).open(url, size=(800, 600))
        page.until(LIVE, timeout=60)

        def look(title, count, css=None, place=(0, 0)):
            for _ in range(count):
                shot = quick(page)
                if css: cv2.circle(shot, tuple(int(n) for n in page.place(css, *place)), 18, (0, 140, 255), 5)
                images.append(shot)
                titles.append(title)
                time.sleep(.1)

        def press(title, css, count):
            look(title, 1, css)
            page.click(css)
            look(title, count)

        look("uav-gui --sim --browser", 3)
        for place in ((.6, 0), (0, .6)):
            with page.pressed(".pad", *place): look("press and hold: the gimbal turns", 8, ".pad", place)
        look("let go: it stands still", 3)
        press("take a picture", "button[data-do=snapshot]", 4)
        press("look at what you took", "button.last", 6)
    save("gallery_panel", images, titles, rate=5, rest=1, quality=30)


def keep(name, shot, width=None, quality=62):
    "Write `nbs/images/NAME.webp`, `width` pixels wide"
    if width: shot = cv2.resize(shot, (width, round(width*shot.shape[0]/shot.shape[1])), interpolation=cv2.INTER_AREA)
    file = FOLDER/f"{name}.webp"
    Image.fromarray(shot[..., ::-1]).save(file, quality=quality, method=6)
    print(f"{file.name}: {shot.shape[1]} x {shot.shape[0]}, {file.stat().st_size/1000:.0f} kB")


def shown(page, key, test, rest=1.):
    "What the page shows after a key, when `test` holds: its tooltips are gone, and its pictures have come"
    page.driver.find_element("css selector", "body").send_keys(key)
    page.until(test, timeout=240)
    time.sleep(rest)
    return page.screenshot()


def middle_tag(shot, size):
    "The corners of the AprilTag nearest to the middle, from -1 to 1; a small one is hard to track"
    tags = [2*corners/size-1 for corners in find_tags(shot).values() if cv2.contourArea(corners) > 700]
    return min(tags, key=lambda corners: np.linalg.norm(corners.mean(0)))


async def screens():
    "The panel as it is in flight, for the tutorial"
    desktop, upright, aside, drawer = (1280, 800), (390, 844), (844, 390), (1200, 750)
    with ExitStack() as stack:
        browser = stack.enter_context(Browser())
        _, url = panel_of(stack, "udpin:127.0.0.1:14550", title="UAV")
        first = browser.open(url, size=drawer)
        first.until("document.querySelector('.empty li')")
        keep("panel_first_run", first.screenshot(), 900)

    with ExitStack() as stack:
        browser = stack.enter_context(Browser())
        stack.enter_context(sim_vehicle(["virtual:gallery_screens"], rate=10, path="circle"))
        gui, url = panel_of(stack, "virtual:gallery_screens")
        page = browser.open(url, size=desktop)
        page.until(LIVE, timeout=60)
        for _ in range(5):
            assert (await gui.do("snapshot"))["ok"]
            await asyncio.sleep(1.5)
        await gui.do("attitude", pitch=-50, yaw=-40)
        await asyncio.sleep(8)
        page.click(".picture", .25, .1)
        page.until("document.querySelector('.mark span')?.textContent")
        keep("panel", page.screenshot(), 1100)
        for name, dark, key, test in (
                ("map", True, "m", "document.querySelector('.drawer .map, .drawer canvas, .drawer svg')"),
                ("files", False, "f", "document.querySelectorAll('.drawer .art img').length > 4"),
                ("settings", True, "s", "document.querySelectorAll('.drawer select').length > 2")):
            page.look(drawer, dark=dark)
            shown(page, key, test, 3.)
            page.js("document.querySelector('.picture').dispatchEvent(new PointerEvent('pointermove', {bubbles: true}))")
            await asyncio.sleep(1)
            for box in page.driver.find_elements("css selector", ".drawer .pick input")[1:3]: box.click()
            keep(f"panel_{name}", page.screenshot(), 900)
            page.driver.find_element("css selector", "body").send_keys(key)
        await gui.do("attitude", pitch=-25, yaw=0)
        await gui.do("record", on=True)
        for name, size in (("phone", upright), ("phone_aside", aside)):
            hand = browser.open(url, size=size, touch=True)
            hand.until(LIVE, timeout=60)
            await asyncio.sleep(2)
            with hand.pressed(".pad", .6, -.3, touch=True):
                await asyncio.sleep(.7)
                keep(f"panel_{name}", hand.screenshot())
        await gui.do("record", on=False)

    with ExitStack() as stack:
        browser = stack.enter_context(Browser())
        stack.enter_context(sim_vehicle(["virtual:gallery_target"], rate=10, pitch=-45))
        gui, url = panel_of(stack, "virtual:gallery_target")
        page = browser.open(url, size=drawer)
        page.until(LIVE, timeout=60)
        await asyncio.sleep(3)
        corners = middle_tag(page.screenshot(), drawer)
        page.press(".picture", *(corners.min(0)-.02))
        page.move(".picture", *(corners.max(0)+.02))
        page.let_go()
        page.until("document.querySelector('button[data-do=follow_target]:not([hidden])')", timeout=20)
        page.click("button[data-do=follow_target]")
        page.until("document.querySelector('[data-turning]')", timeout=20)
        await asyncio.sleep(1)
        keep("panel_track", page.screenshot(), 900)


async def track():
    "A gimbal that follows a car, by what the camera's tracker says"
    shots = []
    vehicle = SimVehicle(circle(radius=100, speed=4, altitude=40, middle=(-100, 0)))
    with ExitStack() as stack:
        turned = SimGimbal(vehicle)
        camera = TruthCamera(mount=turned, car_speed=3)
        client, pilot = await aircraft_with(stack, "virtual:gallery_track", vehicle, turned, camera)
        for thing in (turned, camera): stack.callback(thing.close)
        size = np.array([camera.lens.horizontal_fov, -camera.lens.horizontal_fov*.75])
        async with pilot.control():
            lat, lon, alt = vehicle.on_earth(*camera.world.car(camera.number/camera.frame_rate)[:2], 0)
            await pilot.point_at(lat, lon, alt, alt_frame="amsl")
            await asyncio.sleep(2)
            await client.camera().tracking.rectangle(**camera.around_car())
            keeping_up = np.zeros(2)
            async for status in client.camera().tracking.updates(rate=10):
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
        ack = await client.camera().trigger_every(metres=12, first=True)
        assert ack, ack
        vehicle.began = vehicle.clock()
        end = vehicle.path(1e6)
        while vehicle.position() != end: await asyncio.sleep(.1)
        await client.camera().trigger_every(metres=0)
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
    makers = dict(gimbal=gimbal, panel=panel, track=track, survey=survey, screens=screens)
    for name in sys.argv[1:] or makers: asyncio.run(makers[name]())
