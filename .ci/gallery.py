#!/usr/bin/env python3
"""Make the pictures of the panel, nbs/images/gallery_panel.webp and panel*.webp, from real runs of the package, with Chromium.

Usage, from the project's root, in its development environment:
    python .ci/gallery.py [panel] [screens]
Without names it makes all. Vehicle, gimbal and camera are simulated; commands, notices, tracker, panel and files are those that a real
vehicle meets. Run it when the look of the panel has changed. The other moving pictures of the front page don't show the panel; what
made them is in the history: `git show 23b3ed7:.ci/gallery.py`.
"""
import asyncio, sys, time
from base64 import b64decode
from contextlib import ExitStack
from pathlib import Path
import cv2, numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import get_data_path

from UAV.cameras.sim import find_tags
from UAV.cli.gui import sim_vehicle
from UAV.manager import Gui
from UAV.mavlink import CameraClient, GimbalClient, MAVCom, mavlink
from tests.browser import Browser
from UAV.testing import free_port

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


if __name__ == "__main__":
    makers = dict(panel=panel, screens=screens)
    for name in sys.argv[1:] or makers: asyncio.run(makers[name]())
