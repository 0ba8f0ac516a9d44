"""The live page in Chromium, at a desk and on a phone in the dark: its numbers are the library's."""

import math
import re
import urllib.parse

import live_pages
import numpy as np
import pytest
import tdmf_slip
from conftest import reference_gaits, runner_of_gait
from live_pages import (
    EQUAL,
    close,
    drag_friction,
    eigenvalues,
    find,
    find_gait,
    hint,
    js,
    open_page,
    paint,
    play,
    pointer,
    press,
    sentence,
    show,
    show_curve,
    size_of,
    type_value,
    value_shown,
    wait,
)
from selenium.webdriver.common.by import By
from selenium.webdriver.support.select import Select
from tdmf_slip.analysis.ball import fates
from tdmf_slip.analysis.basin import range_around
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.members import INPUTS, PARAMETERS, names_of
from tdmf_slip.pictures import style
from tdmf_slip.variables.parameters import read_parameters
from tdmf_slip.variables.table import STATES, paper_unit

built, address, driver = live_pages.built, live_pages.address, live_pages.driver
page, used_page = live_pages.page, live_pages.used_page

CLAMP = "hip.swing_clamp"
MAX_BYTES = 1_000_000


def test_the_page_and_all_that_it_loads_is_small_and_its_own(page, built, address):
    assert size_of(built) < MAX_BYTES
    loaded = js(page, "performance.getEntriesByType('resource').map((entry) => entry.name)")
    assert f"{address}/live/live_core.wasm" in loaded and len(loaded) > 15
    for name in loaded:
        assert name.startswith(f"{address}/live/") and (built / name.removeprefix(f"{address}/")).is_file()


@pytest.mark.on_phone
def test_there_is_a_control_for_every_parameter_input_and_start_value(used_page, fmu):
    wanted = [*names_of(PARAMETERS), *names_of(INPUTS), *STATES]
    rows = js(
        used_page,
        "[...document.querySelectorAll('.control')].map((row) => ["
        "row.querySelector('label').htmlFor.replace('value-', ''),"
        "row.querySelector('.set span')?.textContent,"
        "row.querySelector('p').textContent])",
    )
    assert sorted(name for name, _, _ in rows) == sorted(wanted)
    for name, shown, note in rows:
        variable = fmu.variables[name]
        factor = next(iter(variable.display_units.values()), 1.0)
        assert note.startswith(variable.description)
        if variable.type == "Boolean":
            assert shown is None and note.endswith(f"; default {str(variable.start).lower()}")
            continue
        numbers = re.search(r"default (\S+), from (\S+) to (\S+)", note).groups()
        limits = (variable.minimum, variable.maximum)
        for text, value in zip(numbers, (variable.start, *limits), strict=True):
            assert float(text.replace("−", "-")) == pytest.approx(value * factor, rel=1e-5)
        value_shown = {"": "", "1": "", "rad": "°", "rad/s": "deg sqrt(k/m)"}
        wanted = value_shown.get(variable.unit) or paper_unit(variable.unit or "1")
        assert shown == style.printed(wanted).replace("deg", "°").removesuffix("1"), name


def set_clamp(page, clamp):
    box = find(page, f"value-{CLAMP}")
    page.execute_script("if (arguments[0].checked !== arguments[1]) arguments[0].click()", box, clamp)


def test_the_five_published_gaits_are_found(page):
    """The presets are of the default runner, whose swing is free."""
    presets = Select(find(page, "preset"))
    compared = 0
    for number, reference in enumerate(reference_gaits(False)):
        presets.select_by_value(str(number))
        find_gait(page)
        assert value_shown(page, "gait", "word") == reference["word"]
        for name in ("period", "speed", "length", "cost_of_transport"):
            assert close(value_shown(page, "gait", f"stride.{name}"), reference[name])
        gait = tdmf_slip.find_gait(runner_of_gait(reference))
        assert np.abs(eigenvalues(page) - gait.eigenvalues).max() < EQUAL
        lasting = reference["eigenvalues"][:3]  # the others are rounded to 0
        assert np.abs(eigenvalues(page)[:3] - lasting).max() < EQUAL
        assert close(value_shown(page, "gait", "lambda_max"), gait.lambda_max)
        assert value_shown(page, "gait", "stable") == "stable"
        compared += 1
    assert compared == 5


def test_a_run_on_a_gait_has_its_numbers(page):
    Select(find(page, "preset")).select_by_visible_text("human scale")
    find_gait(page)
    gait = tdmf_slip.find_gait(read_parameters("human"))
    press(page, "start-gait")
    page.execute_script("tdmfSlip.player.play(false)")
    while int(value_shown(page, "numbers", "stride.count")) < 10:
        page.execute_script(
            "tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(arguments[0]))", gait.period / 3
        )
    assert value_shown(page, "numbers", "word") == gait.word == "+0+"
    assert close(value_shown(page, "numbers", "stride.speed"), gait.stride["speed"])
    assert close(value_shown(page, "numbers", "stride.cost_of_transport"), gait.stride["cost_of_transport"])
    fields = "[...document.querySelectorAll('.numbers dd')]"
    beyond = js(page, f"{fields}.map((field) => field.scrollWidth - field.clientWidth)")
    assert len(beyond) >= 16 and max(beyond) <= 0  # no number is cut off


def closes(ledger):
    """True if all works less all losses equal the change of energy."""
    losses = sum(value for name, value in ledger.items() if name.endswith("_loss"))
    work = sum(value for name, value in ledger.items() if name.endswith("work"))
    assert losses > 0.1
    return work - losses == pytest.approx(ledger["energy.total"], abs=1e-12)


def test_the_ledger_of_a_stride_closes_also_where_inputs_and_settings_jump_in_it(used_page):
    used_page.execute_script("tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(60))")
    assert closes(js(used_page, "tdmfSlip.run.lastLedger"))
    used_page.execute_script(
        "tdmfSlip.player.advanceBy(() => { do { tdmfSlip.run.advanceToEvent(1000); }"
        "while (tdmfSlip.run.outputs['contact.mode'] !== 2); tdmfSlip.run.advance(0.05); })"
    )
    for name, value in {"leg.extension": 0.02, "leg.thrust": 0.03, "ground.friction": 0.5}.items():
        used_page.execute_script("tdmfSlip.set(...arguments)", name, value)
    strides = int(value_shown(used_page, "numbers", "stride.count"))
    used_page.execute_script("tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(20))")
    assert int(value_shown(used_page, "numbers", "stride.count")) == strides + 1
    ledger = js(used_page, "tdmfSlip.run.lastLedger")
    assert closes(ledger) and ledger["leg.work"] > 1e-3
    used_page.execute_script("tdmfSlip.set('body.mass', 1.01)")  # which changes the energy by no work
    used_page.execute_script("tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(24))")
    assert js(used_page, "tdmfSlip.run.lastLedger") is None


@pytest.mark.on_phone
def test_dragging_the_friction_across_a_border_changes_the_word(page):
    find_gait(page)
    show_curve(page)
    assert value_shown(page, "gait", "word") == "+0-0+"
    drag_friction(page, 0.6, 0.43)
    wait(page, "tdmfSlip.gaits.search.gait.word === '+0-'", "the other word")
    friction = js(page, "tdmfSlip.state.values['ground.friction']")
    assert friction == pytest.approx(0.43, rel=0.02)
    wait(page, f"location.hash === '#ground.friction={friction}'", "the address")
    wait(page, f"tdmfSlip.gaits.search.friction === {friction}", "the gait at the last friction")
    assert close(
        value_shown(page, "gait", "stride.speed"),
        tdmf_slip.find_gait({"ground.friction": friction}).stride["speed"],
    )


def test_the_curve_over_the_friction_is_the_librarys(page):
    find_gait(page)
    show(page)
    points = "tdmfSlip.gaits.frictionPlot.points"
    wait(page, f"{points}.at(0)?.friction < 0.0501 && {points}.at(-1).friction > 9.99", "the curve")
    points = js(page, "tdmfSlip.gaits.frictionPlot.points")
    assert {point["gait"]["word"] for point in points} == {"0+", "+0+", "+0-0+", "+0-", "+-"}
    for point in points[::20]:
        gait = tdmf_slip.find_gait({"ground.friction": point["friction"]})
        assert point["gait"]["word"] == gait.word
        assert close(point["gait"]["stride"]["stride.speed"], gait.stride["speed"])
        assert abs(abs(complex(*point["gait"]["eigenvalues"][0])) - gait.lambda_max) < EQUAL


def test_a_region_around_the_gait_is_the_command_s_until_a_value_changes(page):
    find_gait(page)
    Select(find(page, "region-width")).select_by_value("1")
    Select(find(page, "region-points")).select_by_visible_text("32")
    paint(page)
    region, gait = js(page, "tdmfSlip.gaits.region.read"), tdmf_slip.find_gait()
    for axis, values in zip(region["axes"], (region["rows"], region["columns"]), strict=True):
        assert [values[0], values[-1]] == pytest.approx(range_around(gait, axis), rel=1e-5)
    assert js(page, "tdmfSlip.gaits.region.map.outdated") is None
    outdated, said = page.execute_script(
        "tdmfSlip.set('ground.friction', 0.5);"
        f"return [tdmfSlip.gaits.region.map.outdated, {hint('region-hint')}]"
    )
    assert outdated is True and "other values" in said


def test_every_cell_of_a_painted_region_is_the_librarys(page):
    paint(page)
    region = js(page, "tdmfSlip.gaits.region.read")
    gait = tdmf_slip.find_gait()
    rows, columns = np.array(region["rows"]), np.array(region["columns"])
    starts = np.tile(gait.apex, (32, 32, 1))
    axes = [tdmf_slip.library.section.COORDINATES.index(axis) for axis in region["axes"]]
    starts[..., axes[0]], starts[..., axes[1]] = rows[:, None], columns[None, :]
    ends = fates(gait, starts.reshape(-1, 6))
    assert region["fates"] == [FATES[number] for number in ends["fate"]]
    assert region["strides"] == ends["strides"].tolist()
    assert len(region["fates"]) == 32 * 32 and {"settled", "fell", "no_start"} <= set(region["fates"])


@pytest.mark.on_phone
def test_a_click_into_the_region_starts_the_runner_there(page):
    paint(page)
    canvas = find(page, "region")
    page.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
    pointer(page).move_to_element_with_offset(canvas, 30, -40).click().perform()
    apex = js(page, "tdmfSlip.core.apexOf(tdmfSlip.state.values)")
    gait = tdmf_slip.find_gait().apex
    assert apex[0] > 1.2 * gait[0] and apex[1] > 1.1 * gait[1]
    assert apex[2:] == pytest.approx(gait[2:], abs=1e-10)
    wait(page, "location.hash.includes('foot.vx=')", "the address")


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("ground.friction", "NaN", "ground.friction is no number: allowed from 0 to 1000000"),
        ("ground.friction", "-1", "ground.friction = -1 is refused: allowed from 0 to 1000000"),
        ("ground.friction", "slippery", "ground.friction is no number: allowed from 0 to 1000000"),
        ("ground.friction", "", "ground.friction is no number: allowed from 0 to 1000000"),
        ("hip.touchdown_angle", "steep", "hip.touchdown_angle is no number: allowed from -90 to 90 deg"),
        ("foot.vx", "2e12", "foot.vx = 2e+12 m/s is refused: allowed from -1e+12 to 1e+12 m/s"),
    ],
)
def test_a_bad_value_gets_a_sentence_and_the_runner_runs_on(used_page, name, text, says):
    play(used_page, True)
    before = js(used_page, "[tdmfSlip.state.values, tdmfSlip.run.time]")
    type_value(used_page, name, text)
    assert sentence(used_page) == says
    assert find(used_page, f"value-{name}").get_attribute("aria-invalid") == "true"
    assert js(used_page, "tdmfSlip.state.values") == before[0]
    wait(used_page, f"tdmfSlip.run.time > {before[1]} + 1", "the run")
    type_value(used_page, name, "0.5")
    assert (
        sentence(used_page) == "" and find(used_page, f"value-{name}").get_attribute("aria-invalid") is None
    )


def test_an_address_shows_the_same_runner(driver, address):
    open_page(driver, address, "#friction=0.3&hip.touchdown_angle=0.7&leg.angle=1.1")
    values = js(driver, "tdmfSlip.state.values")
    assert (values["ground.friction"], values["hip.touchdown_angle"], values["leg.angle"]) == (0.3, 0.7, 1.1)
    assert float(find(driver, "value-hip.touchdown_angle").get_attribute("value")) == pytest.approx(
        math.degrees(0.7)
    )
    unit = "return document.getElementById('value-leg.stiffness').nextSibling.textContent"
    assert driver.execute_script(unit) == "k"
    type_value(driver, "body.mass", "1.25")
    wait(driver, "location.hash.includes('body.mass')", "the address")
    assert driver.execute_script(unit) == "N/m"
    said = urllib.parse.parse_qs(js(driver, "location.hash.slice(1)"))
    assert said.pop("body.mass") == ["1.25"] and said.pop("ground.friction") == ["0.3"]
    assert said.keys() == {"hip.touchdown_angle", "leg.angle"}
    driver.execute_script("location.hash = '#gait-title'")  # a place on the page is no runner
    wait(driver, "location.hash === '#gait-title'", "the address")
    assert sentence(driver) == "" and js(driver, "tdmfSlip.state.values['ground.friction']") == 0.3


def test_the_clamp_of_the_swing_is_a_checkbox(page, address):
    box = find(page, f"value-{CLAMP}")
    assert box.get_attribute("type") == "checkbox"
    for clamp in (False, True):
        set_clamp(page, clamp)
        assert js(page, f"tdmfSlip.state.values['{CLAMP}']") == clamp
        find_gait(page)
        gait = tdmf_slip.find_gait({CLAMP: clamp})
        assert close(value_shown(page, "gait", "stride.speed"), gait.speed)
        assert np.abs(eigenvalues(page) - gait.eigenvalues).max() < EQUAL
    for text, clamp in (("false", 0), ("0", 0), ("true", 1)):
        open_page(page, address, f"#{CLAMP}={text}")
        assert js(page, f"tdmfSlip.state.values['{CLAMP}']") == clamp
        assert find(page, f"value-{CLAMP}").is_selected() == bool(clamp)
    page.execute_script("arguments[0].click()", find(page, f"value-{CLAMP}"))
    wait(page, "location.hash === ''", "the address")
    page.execute_script("arguments[0].click()", find(page, f"value-{CLAMP}"))
    wait(page, f"location.hash === '#{CLAMP}=true'", "the address")


def test_a_bad_address_gets_a_sentence(driver, address):
    open_page(driver, address, f"#{CLAMP}=maybe")
    assert f"{CLAMP} = maybe in the address is refused: allowed are true and false." in sentence(driver)
    open_page(driver, address, "#ground.friction=ice&colour=red")
    assert "colour in the address is no parameter" in sentence(driver)
    assert "ground.friction is no number" in sentence(driver)
    assert js(driver, "tdmfSlip.state.values['ground.friction']") == 0.6


def test_a_fall_and_a_runner_too_stiff_are_told(driver, address):
    open_page(driver, address, live_pages.FALLING)
    wait(driver, "tdmfSlip.run.over", "the fall")
    assert find(driver, "announcement").get_attribute("textContent") == "The runner fell."
    assert find(driver, "play").text == "Run again"
    driver.execute_script("tdmfSlip.view.draw(); tdmfSlip.view.tell()")
    cell = driver.find_element(By.CSS_SELECTOR, "#numbers [data-name='contact.mode']")
    assert (cell.text, cell.get_attribute("data-value")) == ("fallen", "fallen")
    assert find(driver, "scene").get_attribute("aria-label").startswith("The runner: fallen;")
    open_page(driver, address, "#foot.mass=1e-12")
    wait(driver, "tdmfSlip.run.over", "the end")
    assert "too stiff" in sentence(driver)


def changes_within(page, body, events):
    """True if contact or phase change within so many events; events of the clamp change neither."""
    for _ in range(events):
        body.send_keys("e")
        if js(page, "tdmfSlip.run.outputs['event.last_time'] === tdmfSlip.run.time"):
            return True
    return False


@pytest.mark.both_screens
def test_keys_and_taps_run_pause_and_step(page):
    play(page, True)
    body = page.find_element(By.TAG_NAME, "body")
    body.send_keys(" ")
    assert not js(page, "tdmfSlip.player.running")
    time = js(page, "tdmfSlip.run.time")
    body.send_keys(".")
    assert js(page, "tdmfSlip.run.time") == pytest.approx(time + 0.01)
    assert changes_within(page, body, 4)
    assert "centre of mass" in find(page, "scene").get_attribute("aria-label")
    body.send_keys("]")
    assert js(page, "tdmfSlip.state.values['ground.friction']") == 0.63
    press(page, "scene")
    assert js(page, "tdmfSlip.player.running")


@pytest.mark.both_screens
def test_nothing_is_wider_than_the_screen_and_the_colours_are_those_asked_for(page):
    width, dark = js(
        page, "[document.documentElement.clientWidth, matchMedia('(prefers-color-scheme: dark)').matches]"
    )  # a phone's innerWidth grows with what is too wide
    page.execute_script("document.querySelectorAll('details').forEach((group) => { group.open = true; })")
    assert js(page, "document.documentElement.scrollWidth") <= width
    shade = js(page, "getComputedStyle(document.body).backgroundColor")
    assert (max(map(int, re.findall(r"\d+", shade))) < 64) == dark
    press(page, "theme")
    other = js(page, "getComputedStyle(document.body).backgroundColor")
    assert (max(map(int, re.findall(r"\d+", other))) < 64) != dark
