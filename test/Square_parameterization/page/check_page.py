#!/usr/bin/env python3
# Copyright (c) 2026 The CGAL_ext authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens a page of `square_map --report` in headless Chromium, looks at it, and uses it.

    check_page.py CHROMIUM PAGE.html [--screenshot FILE.png] [--seconds S] [--unused]

Fails when the page asks for anything, when something is on the console, when no picture is drawn within a minute, or the
seconds asked for, when a picture is blank or the rectangle of the map has another shape, and when the switches, the
pointer or the mouse wheel change nothing. Prints how long the first picture took, by the clock and of the processors, of
all processes of the browser together: figures of the machine and of its browser, which tests do not look at.
"""

import argparse
import base64
import io
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from PIL import Image, ImageChops, ImageFilter

WIDTH, HEIGHT = 1200, 1000


class Browser:
    """Chromium, spoken to in its own protocol through a pipe: messages of JSON that end with a zero."""

    def __init__(self, program, folder):
        to_browser, self.output = os.pipe()
        self.input, from_browser = os.pipe()

        def connect():  # the protocol takes the file descriptors 3 and 4
            ends = os.dup(to_browser), os.dup(from_browser)
            for end, place in zip(ends, (3, 4)):
                os.dup2(end, place)

        arguments = ["--headless=new", "--no-sandbox", "--remote-debugging-pipe", f"--user-data-dir={folder}",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run",
                     "--disable-background-networking", f"--window-size={WIDTH},{HEIGHT}", "about:blank"]
        self.process = subprocess.Popen([program] + arguments, preexec_fn=connect, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.pending, self.events, self.number, self.session = b"", [], 0, None

    def receive(self):
        while b"\0" not in self.pending:
            received = os.read(self.input, 1 << 20)
            if not received:
                raise RuntimeError("the browser has ended")
            self.pending += received
        message, self.pending = self.pending.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.output, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def value_of(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def processor_seconds(self):
        """What all processes of the browser have used of processors since they began."""
        session, self.session = self.session, None  # a question to the browser, not to the page
        processes = self.ask("SystemInfo.getProcessInfo")["processInfo"]
        self.session = session
        return sum(process["cpuTime"] for process in processes)

    def wait_for_frames(self, count=3):
        self.value_of(f"new Promise(done => {{ let n = {count}; const next = () => n-- > 0 ? "
                      "requestAnimationFrame(next) : done(); next(); })")

    def screenshot(self):
        self.wait_for_frames()
        png = base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])
        return Image.open(io.BytesIO(png)).convert("RGB"), png

    def mouse(self, kind, place, **more):
        self.ask("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], **more)


def rectangle_of(browser, name):
    return browser.value_of(f"(() => {{ const r = document.getElementById('{name}').getBoundingClientRect();"
                            "return [r.left, r.top, r.right, r.bottom]; })()")


def panel(browser, name):
    """What is drawn in a panel, without the line around it."""
    left, top, right, bottom = rectangle_of(browser, name)
    return browser.screenshot()[0].crop((left + 4, top + 4, right - 4, bottom - 4))


def share_drawn(picture):
    """The share of pixels that are not of the white background."""
    pixels = list(picture.getdata())
    return sum(pixel != (255, 255, 255) for pixel in pixels) / len(pixels)


def middle_of_drawing(browser, name):
    """Of the places in a panel with something drawn around them, one that is nearest to the middle."""
    picture, (left, top, _, _) = panel(browser, name), rectangle_of(browser, name)
    drawn = ImageChops.difference(picture, Image.new("RGB", picture.size, "white")).convert("L").point(
        lambda brightness: 255 * (brightness > 0)).filter(ImageFilter.MinFilter(9))
    middle = picture.width / 2 + 3, picture.height / 2 + 3  # not where a line may be
    pixels = drawn.load()
    places = [(x, y) for y in range(picture.height) for x in range(picture.width) if pixels[x, y]]
    x, y = min(places, key=lambda place: math.dist(place, middle))
    return [left + 4 + x, top + 4 + y]


def share_changed(before, after):
    pairs = list(zip(before.getdata(), after.getdata()))
    return sum(a != b for a, b in pairs) / len(pairs)


def faults_of_pictures(browser):
    for name in ("surface", "square"):
        picture = panel(browser, name)
        if share_drawn(picture) < 0.01 or len(picture.getcolors(1 << 24)) < 3:
            yield f"the panel {name} is blank"
    yield from faults_of_rectangle(panel(browser, "square"), browser)


def faults_of_rectangle(picture, browser):
    """Whether the map is drawn on its rectangle, as far as lines around it let tell."""
    aspect = browser.value_of("JSON.parse(document.getElementById('page').textContent).report.best.aspect")
    left, top, right, bottom = ImageChops.difference(picture, Image.new("RGB", picture.size, "white")).getbbox()
    width, height, line = right - left, bottom - top, 8
    if not (width - line) / (height + line) <= aspect <= (width + line) / (height - line):
        yield f"a rectangle of aspect {aspect} is drawn with {width} by {height} pixels"


def faults_of_use(browser):
    """What is wrong with the switches and the pointer."""
    panels = {name: panel(browser, name) for name in ("surface", "square")}
    browser.value_of("document.querySelector('input[value=stretch]').click()")
    for name, before in panels.items():
        if share_changed(before, panel(browser, name)) < 0.02:
            yield f"the colors of the panel {name} do not change"
    if browser.value_of("document.getElementById('colors').clientWidth") == 0:
        yield "the colors have no scale"
    browser.value_of("document.querySelector('input[value=checkerboard]').click()")
    if not browser.value_of("document.getElementById('candidates').disabled"):
        browser.value_of("document.querySelector('input[value=first]').click()")
        browser.wait_for_frames(25)
        if share_changed(panels["surface"], panel(browser, "surface")) < 0.01:
            yield "the first candidate looks like the best"
        browser.value_of("document.querySelector('input[value=best]').click()")
        browser.wait_for_frames(25)
        if share_changed(panels["surface"], panel(browser, "surface")) > 0.001:
            yield "the best candidate does not come back"
    for name, other in (("square", "surface"), ("surface", "square")):
        before = panel(browser, other)
        browser.mouse("mouseMoved", middle_of_drawing(browser, name))
        after = panel(browser, other)
        words = browser.value_of("document.getElementById('face').textContent")
        if not words.startswith("Face "):
            yield f"no face is under the pointer in the panel {name}: {words}"
        elif share_changed(before, after) == 0:
            yield f"the face under the pointer in the panel {name} is not marked in the other"
        browser.mouse("mouseMoved", [3, 3])
    for name in panels:
        left, top, right, bottom = rectangle_of(browser, name)
        browser.mouse("mouseWheel", [(left + right) / 2, (top + bottom) / 2], deltaX=0, deltaY=-300)
        if share_changed(panels[name], panel(browser, name)) < 0.02:
            yield f"the mouse wheel changes nothing in the panel {name}"
    left, top, right, bottom = rectangle_of(browser, "surface")
    before = panel(browser, "surface")
    middle = [(left + right) / 2, (top + bottom) / 2]
    browser.mouse("mousePressed", middle, button="left", buttons=1, clickCount=1)
    browser.mouse("mouseMoved", [middle[0] + 90, middle[1]], button="left", buttons=1)
    browser.mouse("mouseReleased", [middle[0] + 90, middle[1]], button="left", clickCount=1)
    if share_changed(before, panel(browser, "surface")) < 0.02:
        yield "the surface does not turn"


def faults_of_events(events, address):
    """What the page asked for, and what it said on the console."""
    for event in events:
        parameters = event.get("params", {})
        if event.get("method") == "Network.requestWillBeSent":
            requested = parameters["request"]["url"]
            if requested != address and not requested.startswith("data:"):
                yield f"a request to {requested}"
        elif event.get("method") in ("Runtime.consoleAPICalled", "Runtime.exceptionThrown"):
            yield "on the console: " + json.dumps(parameters)
        elif event.get("method") == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            if "GPU stall due to ReadPixels" not in parameters["entry"]["text"]:  # of the driver, in slow machines
                yield "on the console: " + parameters["entry"]["text"]


def check(arguments, browser):
    target = browser.ask("Target.createTarget", url="about:blank", newWindow=True,
                         width=WIDTH, height=HEIGHT)["targetId"]
    browser.session = browser.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
    for domain in ("Page", "Network", "Runtime", "Log"):
        browser.ask(f"{domain}.enable")
    address = pathlib.Path(arguments.page).resolve().as_uri()
    used_before = browser.processor_seconds()
    browser.ask("Page.navigate", url=address)
    first_picture = None
    end = time.monotonic() + arguments.seconds + 60
    while first_picture is None and time.monotonic() < end:
        time.sleep(0.05)
        first_picture = browser.value_of("document.documentElement?.dataset.firstPicture")
    faults = []
    if first_picture is None:
        faults.append("no picture is drawn: " + str(browser.value_of("document.body.innerText")))
    else:
        used = browser.processor_seconds() - used_before
        print(f"first picture after {first_picture} ms, {used:.2f} seconds of processors")
        if float(first_picture) > 1000 * arguments.seconds:
            faults.append(f"the first picture took {first_picture} ms")
        if arguments.screenshot:
            pathlib.Path(arguments.screenshot).write_bytes(browser.screenshot()[1])
        faults += faults_of_pictures(browser)
        if not arguments.unused:
            faults += faults_of_use(browser)
    return faults + list(faults_of_events(browser.events, address))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("chromium")
    parser.add_argument("page")
    parser.add_argument("--screenshot")
    parser.add_argument("--seconds", type=float, default=60, help="for the first picture; default 60")
    parser.add_argument("--unused", action="store_true", help="look at the first picture alone")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        browser = Browser(arguments.chromium, folder)
        try:
            faults = check(arguments, browser)
        finally:
            browser.process.kill()
            browser.process.wait()
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
