"""The live page in Debian's Chromium, without a window: for the tests, and for measuring."""

import contextlib
import functools
import http.server
import pathlib
import shutil
import threading

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.wait import WebDriverWait

PATIENCE = 600.0
"""Seconds after which a page is said to hang; nothing else depends on them."""
PHONE = 700
"""CSS pixels; a narrower page is a phone's, with touch."""


class _Handler(http.server.SimpleHTTPRequestHandler):
    """Files as they are at each request, and nothing said about it."""

    def end_headers(self):
        """Forbid a copy: a file changed within a second has the same date, and would not be read again."""
        self.send_header("Cache-Control", "no-store")
        super().end_headers()

    def log_message(self, *_):
        """Say nothing."""


@contextlib.contextmanager
def served(folder):
    """The address of a plain server of a folder's files."""
    handler = functools.partial(_Handler, directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
            thread.join()


@contextlib.contextmanager
def chromium(width, height, dark=False):
    """A driver of a browser whose page has so many CSS pixels; narrow ones have touch."""
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("headless=new", "no-sandbox", "disable-gpu", "disable-dev-shm-usage"):
        options.add_argument(f"--{argument}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(shutil.which("chromedriver")))
    try:
        screen = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < PHONE}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", screen)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})
        driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": width < PHONE})
        driver.set_script_timeout(PATIENCE)
        yield driver
    finally:
        driver.quit()


@contextlib.contextmanager
def script_first(driver, source):
    """Run a script before those of each page that is opened in this context; then leave the last page."""
    script = driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": source})
    try:
        yield driver
    finally:
        driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)
        driver.get("about:blank")  # stops the runner of the last page


def wait(driver, condition, what="the page"):
    """Wait until a JavaScript expression is true in the page, and return its value."""
    return WebDriverWait(driver, PATIENCE, poll_frequency=0.05).until(
        lambda d: d.execute_script(f"return {condition}"), f"waited in vain for {what}: {condition}"
    )


def open_page(driver, address, state=""):
    """Load the page with a state, `#...`, and wait until it runs."""
    driver.get("about:blank")
    driver.get(f"{address}/live.html{state}")
    wait(
        driver,
        "Boolean(globalThis.tdmfSlip && tdmfSlip.run.outputs && !document.getElementById('find').disabled)",
    )


def size_of(folder):
    """Bytes of the page and of all that it may load."""
    folder = pathlib.Path(folder)
    files = [folder / "live.html", *(folder / "live").iterdir()]
    return sum(file.stat().st_size for file in files)
