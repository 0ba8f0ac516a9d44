"""What was once wrong on the live page, and a person's path through it, at a desk and on a phone."""

import math

import live_pages
import pytest
from conftest import release
from live_pages import (
    SCREENS,
    center,
    drag_friction,
    find,
    find_gait,
    hint,
    js,
    open_page,
    paint,
    play,
    pointer,
    press,
    show,
    show_curve,
    type_value,
    unseen,
    value_shown,
    wait,
)
from selenium.webdriver.common.by import By
from selenium.webdriver.support.select import Select
from tdmf_slip.variables.parameters import read_parameters

built, address, driver = live_pages.built, live_pages.address, live_pages.driver
page, used_page = live_pages.page, live_pages.used_page

FRICTION = "tdmfSlip.state.values['ground.friction']"
COLOURED_PIXELS = """
const scene = document.getElementById('scene'), colour = document.createElement('canvas').getContext('2d');
colour.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--second');
colour.fillRect(0, 0, 1, 1);
const [r, g, b] = colour.getImageData(0, 0, 1, 1).data;
const below = Math.round(0.8 * scene.height), height = scene.height - below;
const all = scene.getContext('2d').getImageData(0, below, scene.width, height).data;
let count = 0;
for (let i = 0; i < all.length; i += 4) { count += all[i] === r && all[i + 1] === g && all[i + 2] === b; }
return count;
"""
"""Counts pixels that have a patch's colour, in the lowest fifth of the picture of the runner."""


def test_a_region_of_other_values_is_said_to_be(page):
    find_gait(page)
    paint(page)
    assert js(page, "tdmfSlip.gaits.region.map.outdated") is None
    outdated, said = page.execute_script(
        "tdmfSlip.set('ground.friction', 0.5);"
        f"return [tdmfSlip.gaits.region.map.outdated, {hint('region-hint')}]"
    )
    assert outdated is True and "other values" in said
    wait(page, "tdmfSlip.gaits.search.gait !== null && !tdmfSlip.gaits.search.following", "the gait")


def test_a_preset_chosen_while_the_region_is_painted_ends_it(page):
    find_gait(page)
    Select(find(page, "region-points")).select_by_visible_text("64")
    show(page)
    press(page, "paint")
    wait(page, f"{hint('region-hint')}.includes('Painting')", "the begin")
    said = page.execute_script(
        "const preset = document.getElementById('preset'); preset.selectedIndex = 2;"
        f"preset.dispatchEvent(new Event('change')); return {hint('region-hint')}"
    )
    assert "Painting" not in said
    wait(page, f"{hint('region-hint')}.includes('settle on the gait')", "the region of the other gait")
    painted, found = js(page, "[tdmfSlip.gaits.region.map.apex, tdmfSlip.gaits.search.gait.apex]")
    assert painted == found


@pytest.mark.on_phone
def test_noise_is_zero_and_no_number_is_cut_off(page):
    Select(find(page, "preset")).select_by_value("0")
    assert js(page, f"{FRICTION}") == 10
    find_gait(page)
    press(page, "start-gait")
    page.execute_script("tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(30))")
    cells = page.find_elements(By.CSS_SELECTOR, ".numbers dd")
    assert len(cells) >= 16
    for cell in cells:
        wide, room = js(page, "[arguments[0].scrollWidth, arguments[0].clientWidth]", cell)
        assert wide <= room, cell.text
        assert not js(page, "getComputedStyle(arguments[0]).textOverflow === 'ellipsis'", cell)
    for ident in ("gait", "numbers"):
        assert abs(float(value_shown(page, ident, "stride.slip_distance"))) < 1e-9
        cell = page.find_element(By.CSS_SELECTOR, f"#{ident} [data-name='stride.slip_distance']")
        assert cell.text.replace(" ", "") == "0l₀"
    shown = [item.text for item in page.find_elements(By.CSS_SELECTOR, "#eigenvalues li")]
    assert len(shown) == 6 and shown[3:] == ["0", "0", "0"]


@pytest.mark.both_screens
def test_a_vertical_swipe_over_the_friction_plot_scrolls(page):
    find_gait(page)
    canvas = find(page, "friction")
    center(page, canvas)
    touches = js(page, "navigator.maxTouchPoints > 0")
    if touches:
        pointer(page).move_to_element_with_offset(
            canvas, 60, 60
        ).click_and_hold().move_to_element_with_offset(canvas, 62, 10).move_to_element_with_offset(
            canvas, 63, -60
        ).release().perform()
        assert js(page, f"{FRICTION}") == 0.6
    pointer(page).move_to_element_with_offset(canvas, 60, 0).click().perform()
    wait(page, f"{FRICTION} !== 0.6", "what a tap sets")


def test_both_ends_of_every_slider_and_every_preset_are_within_what_the_core_accepts(used_page):
    tried = used_page.execute_script(
        "const tried = []; const { presets } = await import('./live/data.js');"
        "for (const preset of [{ name: 'defaults', values: {} }, ...presets]) {"
        "  tdmfSlip.choose(preset);"
        "  for (const [name, control] of tdmfSlip.controls.all) {"
        "    if (!control.slider) continue;"  # a checkbox has no ends
        "    const value = tdmfSlip.state.values[name]; const { low, high } = control.reach;"
        "    const given = { ...tdmfSlip.state.values };"
        "    const ends = ['0', '1000'].map((place) => { control.slider.value = place;"
        "      return tdmfSlip.core.accept({ ...given, [name]: control.sliderValue() }); });"
        "    control.show(value, given);"
        "    const shown = Math.abs(control.sliderValue() - value) <= 0.02 * (high - low);"
        "    tried.push([preset.name, name, low <= value && value <= high && shown, ...ends]);"
        "  } tdmfSlip.core.accept(tdmfSlip.state.values); } return tried"
    )
    assert len(tried) > 300
    assert [row for row in tried if not all(row[2:])] == []


def test_a_value_that_the_slider_does_not_reach_moves_its_reach(used_page):
    type_value(used_page, "body.external_fx", "-5")
    control = "tdmfSlip.controls.all.get('body.external_fx')"
    low, high, value = js(used_page, f"[{control}.reach.low, {control}.reach.high, {control}.sliderValue()]")
    assert low < -5 < high and value == pytest.approx(-5, rel=0.02)


def test_no_gait_blames_what_was_changed(driver, address):
    open_page(driver, address, "#ground.slope=40deg")
    press(driver, "find")
    wait(driver, f"{hint('gait-hint')}.startsWith('No gait')", "the reason")
    text = find(driver, "gait-hint").text
    assert "friction" not in text and text.endswith("With ground.slope = 40°.")


@pytest.mark.parametrize("end", [-50, 50], ids=["no patch", "patch"])
def test_a_patch_is_drawn_and_has_no_gait(driver, address, end):
    patch = f"ground.patch_begin=-50&ground.patch_end={end}&ground.patch_friction=0.05"
    open_page(driver, address, f"#ground.friction=1&{patch}")
    wait(driver, f"Boolean({hint('gait-hint')}.match(/^(Gait|No gait)/))", "the gait or the reason")
    driver.execute_script("tdmfSlip.view.draw()")
    shown = driver.execute_script(COLOURED_PIXELS)
    text = find(driver, "gait-hint").text
    if end == 50:
        assert shown > 200 and text.startswith("No gait was looked for: on a patch") and "apex" not in text
        assert [find(driver, f"{card}-hint").text for card in ("friction", "region")] == [
            "There is no gait."
        ] * 2
    else:
        assert shown == 0 and text.startswith("Gait ")


def test_the_axes_of_the_region_are_never_the_same(used_page):
    rows, columns = (Select(find(used_page, f"region-{name}")) for name in ("rows", "columns"))

    def chosen():
        return [int(select.first_selected_option.get_attribute("value")) for select in (rows, columns)]

    before = chosen()
    rows.select_by_value(str(before[1]))
    assert chosen() == before[::-1]
    columns.select_by_value(str(before[1]))
    assert chosen() == before


def test_the_pace_says_how_fast_it_is(used_page):
    full = math.sqrt(20000 / 80)
    Select(find(used_page, "pace")).select_by_value("full")
    assert find(used_page, "pace-text").text == f"each second shows {full:.3g} √(m/k) of the run"
    Select(find(used_page, "pace")).select_by_value("stance")
    assert (
        find(used_page, "pace-text").text
        == f"each second shows {full:.3g} √(m/k) of a flight, {full / 10:.3g} √(m/k) of a stance"
    )
    Select(find(used_page, "preset")).select_by_visible_text("human scale")
    human = read_parameters("human")
    second = full * math.sqrt(human["body.mass"] / human["leg.stiffness"])
    slow = f"each second shows {second:.3g} s of a flight, {second / 10:.3g} s of a stance"
    assert find(used_page, "pace-text").text == slow


def test_angles_of_an_address_are_in_degrees_and_give_every_bit_back(driver, address):
    values = {"hip.touchdown_angle": 0.7, "leg.angle": 1.1, "ground.slope": math.radians(-2)}
    open_page(driver, address, "#hip.touchdown_angle=0.7&leg.angle=1.1&ground.slope=-2deg")
    assert js(driver, "tdmfSlip.state.values['ground.slope']") == pytest.approx(
        values["ground.slope"], rel=1e-15
    )
    said = js(driver, "tdmfSlip.state.link")
    assert "ground.slope=-2deg" in said and said.count("deg") == 3
    before = js(driver, "tdmfSlip.state.values")
    open_page(driver, address, said[said.index("#") :])
    assert js(driver, "tdmfSlip.state.values") == before


def test_nothing_moves_by_itself_where_motion_is_unwelcome(driver, address):
    dark = js(driver, "matchMedia('(prefers-color-scheme: dark)').matches")
    scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
    reduced = {"name": "prefers-reduced-motion", "value": "reduce"}
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme, reduced]})
    try:
        open_page(driver, address)
        assert find(driver, "play").text == "Run"
        Select(find(driver, "preset")).select_by_index(3)
        assert not js(driver, "tdmfSlip.player.running")
        assert js(driver, "tdmfSlip.run.time") == 0
        press(driver, "play")
        assert js(driver, "tdmfSlip.player.running") and find(driver, "play").text == "Pause"
    finally:
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [scheme]})


@pytest.mark.on_phone
def test_the_theme_is_remembered_and_shared_with_the_guides(page, address):
    press(page, "theme")
    chosen = js(page, "localStorage.getItem('theme')")
    assert chosen == js(page, "document.documentElement.dataset.theme") in ("light", "dark")
    for theme in ("light", "dark", "auto"):
        page.execute_script("localStorage.setItem('theme', arguments[0])", theme)
        open_page(page, address)
        applied = js(page, "document.documentElement.dataset.theme")
        assert applied == (None if theme == "auto" else theme)


@release
def test_a_persons_path(page, address, browsers):
    find_gait(page)
    show_curve(page)
    drag_friction(page, 0.6, 0.43)
    friction = js(page, f"{FRICTION}")
    assert friction == pytest.approx(0.43, rel=0.03)
    wait(page, f"tdmfSlip.gaits.search.friction === {friction} && tdmfSlip.gaits.search.gait", "the gait")
    paint(page)
    region = js(page, "tdmfSlip.gaits.region.read")
    fell = [i for i, fate in enumerate(region["fates"]) if fate == "fell"]
    inner = fell[len(fell) // 2]
    count = len(region["columns"])
    start = [region["columns"][inner % count], region["rows"][inner // count]]
    canvas = find(page, "region")
    center(page, canvas)
    at = page.execute_script(
        "const { axes, surface } = tdmfSlip.gaits.region;"
        "return [axes.x(arguments[0]) - surface.width / 2, axes.y(arguments[1]) - surface.height / 2]",
        *start,
    )
    pointer(page).move_to_element_with_offset(canvas, *map(round, at)).click().perform()
    Select(find(page, "pace")).select_by_value("full")
    play(page, True)
    wait(page, "tdmfSlip.run.fallen", "the fall")
    press(page, "link")
    hash_ = js(page, "location.hash")
    values = js(page, "tdmfSlip.state.values")
    with unseen(browsers(*SCREENS["phone in the dark"])) as phone:
        open_page(phone, address, hash_)
        assert js(phone, "tdmfSlip.state.values") == values
        Select(find(phone, "pace")).select_by_value("full")
        wait(phone, "tdmfSlip.run.fallen", "the same fall")
        assert js(phone, "tdmfSlip.run.time") == pytest.approx(js(page, "tdmfSlip.run.time"), rel=1e-9)
