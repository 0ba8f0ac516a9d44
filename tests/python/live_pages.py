"""The live page in a browser, for its tests: the page's fixtures, and what a person does on it."""

import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest

LIVE = pathlib.Path(__file__).resolve().parents[2] / "documentation" / "live"
sys.path.insert(0, str(LIVE))

pytest.importorskip("selenium")
if not (shutil.which("chromium") and shutil.which("chromedriver")):
    pytest.skip("needs Debian's chromium and chromium-driver", allow_module_level=True)

from browser import open_page, script_first, served, wait  # noqa: E402
from browser import size_of as size_of  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.actions.interaction import POINTER_TOUCH  # noqa: E402
from selenium.webdriver.common.actions.pointer_input import PointerInput  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402

EQUAL = 1e-8
"""Relative for a stride's quantities, absolute for eigenvalues."""
FALLING = "#ground.friction=0&leg.angle_rate=-1"
"""State of a page whose runner falls while its foot slips, at 6.6 sqrt(m/k): within a second on the page."""
SCREENS = {"desk": (1280, 900, False), "phone in the dark": (360, 740, True)}


@pytest.fixture(scope="session")
def built(made_once, site_build_ended):
    """The folder of the page."""

    def build(folder):
        made = subprocess.run([LIVE / "build", folder], capture_output=True, text=True)
        assert made.returncode == 0, made.stderr

    return made_once("live page", build)


@pytest.fixture(scope="module")
def address(built):
    with served(built) as address:
        yield address


UNSEEN = """if (location.search !== "?seen") {
    addEventListener("readystatechange", () => {
        const points = document.getElementById("region-points");
        if (points) points.value = "32";
    }, { once: true, capture: true });
    Object.defineProperty(Document.prototype, "hidden", { get: () => !globalThis.seen, configurable: true });
}"""
"""Makes the page report that it is hidden: it draws no figure 9 and no region, later one of fewer points."""


def unseen(driver):
    """Pages of a browser, except `?seen`, draw figure 9 and the region only after `show` or `paint`."""
    return script_first(driver, UNSEEN)


@pytest.fixture(scope="module", params=SCREENS.values(), ids=SCREENS)
def driver(request, browsers):
    """A browser of unseen pages."""
    driver = browsers(*request.param)
    driver.get_log("browser")  # left by earlier test files
    with unseen(driver):
        yield driver


def check_console(driver):
    """Check that nothing was written to the console."""
    assert [entry["message"] for entry in driver.get_log("browser")] == []


def play(driver, runs):
    """Let the runner run, or stand. Its pictures cost most of the browser's time."""
    driver.execute_script("tdmfSlip.player.play(arguments[0])", runs)


def open_defaults(driver, address):
    open_page(driver, address)
    driver.execute_script("document.querySelector('.region details').open = true")
    play(driver, False)


@pytest.fixture
def page(driver, address):
    """The page at its defaults; the runner stands."""
    open_defaults(driver, address)
    yield driver
    driver.execute_script("localStorage.clear()")
    check_console(driver)


@pytest.fixture
def used_page(driver, address):
    """The page at its defaults, not loaded again, for tests that change only values; the runner stands."""
    if not js(driver, "globalThis.isUsed === true"):
        open_defaults(driver, address)
        driver.execute_script("globalThis.isUsed = true")
    driver.execute_script("tdmfSlip.choose({ name: 'defaults', values: {} })")
    play(driver, False)
    yield driver
    check_console(driver)


def js(driver, expression, *arguments):
    """The value of an expression in JavaScript."""
    return driver.execute_script(f"return {expression}", *arguments)


def show(driver):
    """Make the page report that it is visible."""
    driver.execute_script("globalThis.seen = true; document.dispatchEvent(new Event('visibilitychange'))")


def show_curve(driver):
    """Show the page and wait until figure 9 is drawn."""
    show(driver)
    wait(driver, "tdmfSlip.gaits.frictionPlot.points.length > 60", "figure 9")


def find(driver, ident):
    return driver.find_element(By.ID, ident)


def press(driver, ident):
    """Click an element after opening its group and scrolling to it."""
    driver.execute_script(
        "const group = arguments[0].closest('details'); if (group) { group.open = true; }"
        "arguments[0].scrollIntoView({block: 'center'})",
        find(driver, ident),
    )
    find(driver, ident).click()


def value_shown(driver, ident, name):
    """A number of a list, every digit of it."""
    cell = driver.find_element(By.CSS_SELECTOR, f"#{ident} [data-name='{name}']")
    return cell.get_attribute("data-value")


def find_gait(driver):
    play(driver, False)
    press(driver, "find")
    wait(driver, "tdmfSlip.gaits.search.gait !== null", "the gait")


def eigenvalues(driver):
    items = driver.find_elements(By.CSS_SELECTOR, "#eigenvalues li")
    return np.array(
        [complex(*(float(item.get_attribute(f"data-{part}")) for part in ("re", "im"))) for item in items]
    )


def type_value(driver, name, text):
    field = find(driver, f"value-{name}")
    driver.execute_script(
        "arguments[0].closest('details').open = true; arguments[0].scrollIntoView({block: 'center'})", field
    )
    field.clear()
    field.send_keys(text, Keys.TAB)


def sentence(driver):
    return driver.execute_script(
        "const p = document.getElementById('problem'); return p.hidden ? '' : p.textContent"
    )


def pointer(driver):
    """Actions of a mouse at a desk, of a finger on a phone."""
    touches = js(driver, "navigator.maxTouchPoints > 0")
    finger = PointerInput(POINTER_TOUCH, "finger")
    return ActionChains(driver, duration=50, devices=[finger] if touches else None)


def close(one, other):
    return float(one) == pytest.approx(other, rel=EQUAL)


def center(driver, element):
    """Scroll there; the page is told of it in the next frame, and stands after that."""
    driver.execute_async_script(
        "arguments[0].scrollIntoView({block: 'center'});"
        "requestAnimationFrame(() => requestAnimationFrame(arguments[1]))",
        element,
    )


def hint(ident):
    """JavaScript for a hint's text."""
    return f"document.getElementById('{ident}').textContent"


def paint(driver):
    """Paint the region and wait until it is painted."""
    show(driver)
    press(driver, "paint")
    wait(
        driver, "/settle on the gait/.test(document.getElementById('region-hint').textContent)", "the region"
    )


def drag_friction(driver, begin, end):
    """Draws the pointer over figure 9, from one friction to another."""
    canvas = find(driver, "friction")
    center(driver, canvas)
    where = "tdmfSlip.gaits.frictionPlot.axes.x(arguments[0]) - tdmfSlip.gaits.frictionPlot.surface.width / 2"
    begin, end = (round(js(driver, f"{where}", friction)) for friction in (begin, end))
    drag = pointer(driver).move_to_element_with_offset(canvas, begin, 0).click_and_hold()
    for step in range(1, 5):
        drag.move_to_element_with_offset(canvas, begin + round((end - begin) * step / 4), 0)
    drag.release().perform()
