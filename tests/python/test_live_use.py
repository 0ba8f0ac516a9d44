"""The live page in use: first pictures, presets, regions, races."""

import math

import live_pages
import pytest
import tdmf_slip
from conftest import release
from live_pages import (
    center,
    check_console,
    drag_friction,
    find,
    find_gait,
    hint,
    js,
    open_page,
    pointer,
    press,
    sentence,
    show,
    show_curve,
    type_value,
    wait,
)
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select

built, address, driver = live_pages.built, live_pages.address, live_pages.driver
page, used_page = live_pages.page, live_pages.used_page


# ---- what the page shows by itself -------------------------------------------------------------------------


PAINTED = "performance.getEntriesByName('region painted').map((entry) => entry.detail)"
SENTENCES = {
    "flight": ("rises in flight", "falls in flight"),
    "stick": ("sticks",),
    "slip_positive": ("slides forward",),
    "slip_negative": ("slides backward",),
    "graze": ("grazes",),
}


def test_the_first_pictures_stand_without_a_click(driver, address):
    open_page(driver, address, "?seen")
    wait(driver, f"{PAINTED}.includes(64)", "the region")
    wait(driver, "tdmfSlip.gaits.frictionPlot.points.length > 60", "figure 9")
    assert js(driver, f"{PAINTED}") == [16, 32, 64]
    gait = tdmf_slip.find_gait()
    assert js(driver, "tdmfSlip.gaits.search.gait.word") == gait.word
    region = js(driver, "tdmfSlip.gaits.region.read")
    assert region["axes"] == ["com_height", "com_speed"] and "" not in region["fates"]
    found = js(driver, "performance.getEntriesByName('gait found')[0].startTime")
    assert found < js(driver, "performance.getEntriesByName('region painted')[0].startTime")
    if js(driver, "innerWidth > 900"):
        for ident in ("scene", "gait", "friction", "region"):
            box = find(driver, ident).rect
            assert box["y"] >= 0 and box["y"] + 100 < 900, ident
    assert js(driver, "document.querySelectorAll('#controls details[open]').length") == 0
    check_console(driver)


def test_no_picture_is_computed_while_the_page_is_hidden(page):
    page.execute_script("tdmfSlip.choose({ name: 'another', values: { 'hip.kp': 0.11 } })")
    wait(page, f"{hint('region-hint')}.includes('Painting')", "the begin")
    page.execute_script("tdmfSlip.choose({ name: 'a third', values: { 'hip.kp': 0.12 } })")
    wait(page, f"{hint('region-hint')}.includes('Painting')", "the begin")
    assert len(js(page, "tdmfSlip.gaits.frictionPlot.points")) == 1
    assert set(js(page, "tdmfSlip.gaits.region.read.fates")) == {""}
    show_curve(page)
    wait(page, f"{hint('region-hint')}.includes('settle on the gait')", "the region")
    region = js(page, "tdmfSlip.gaits.region.read")
    assert "" not in region["fates"] and len(region["rows"]) == 32


@pytest.mark.on_phone
def test_the_word_lights_up_letter_by_letter_and_a_sentence_says_what_happens(used_page):
    used_page.execute_script("tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(400))")
    letters, modes = [], set()
    for _ in range(60):
        mode, lit, whole, said = used_page.execute_script(
            "tdmfSlip.player.stepToEvent(); const word = document.getElementById('word');"
            "const run = tdmfSlip.run; const { contactModes } = await import('./live/data.js');"
            "const lit = [...word.querySelectorAll('.lit')].map((letter) => letter.textContent).join('');"
            "return [contactModes[run.outputs['contact.mode']].name, lit, word.textContent,"
            "document.getElementById('now').textContent]"
        )
        assert any(part in said for part in SENTENCES[mode]), (mode, said)
        assert whole == "+0\u22120+" and whole.startswith(lit)
        modes.add(mode)
        letters.append(lit)
    assert set(letters) == {"", "+", "+0", "+0\u2212", "+0\u22120", "+0\u22120+"}
    assert {"flight", "stick", "slip_positive", "slip_negative"} <= modes


@pytest.mark.on_phone
def test_the_large_slider_sets_the_friction_and_follows_it(used_page):
    slider = find(used_page, "friction-slider")
    center(used_page, slider)
    slider.send_keys(Keys.HOME)
    assert js(used_page, "tdmfSlip.state.values['ground.friction']") == 0.05
    assert find(used_page, "friction-text").text == slider.get_attribute("aria-valuetext") == "0.05"
    used_page.execute_script("tdmfSlip.set('ground.friction', 10)")
    assert slider.get_attribute("value") == "1000" and find(used_page, "friction-text").text == "10"


@pytest.mark.on_phone
def test_terms_are_explained_on_hover_and_tap(page):
    """Waits for figure 9, because a page that still grows moves words away from under the pointer."""
    show_curve(page)
    for term in ("graze", "wedge", "arrows", "word", "hip", "gait", "eigenvalue", "friction"):
        element = page.find_element(By.CSS_SELECTOR, f"[data-term='{term}']")
        center(page, element)
        pointer(page).move_to_element(element).click().perform()
        note = find(page, "term-note")
        assert note.is_displayed() and len(note.text) > 40, term
        box = note.rect
        width = js(page, "document.documentElement.clientWidth")
        assert box["x"] >= 0 and box["x"] + box["width"] <= width, term
        ActionChains(page).send_keys(Keys.ESCAPE).perform()
        assert not note.is_displayed(), term


@pytest.mark.on_phone
def test_the_runner_stays_in_sight_while_figure_9_is_dragged_and_the_region_clicked(page):
    show_curve(page)
    for ident in ("friction", "region"):
        center(page, find(page, ident))
        top, bottom = page.execute_script(
            "const box = document.getElementById('scene').getBoundingClientRect();"
            "return [box.top, box.bottom]"
        )
        assert top >= 0 and bottom <= js(page, "innerHeight"), ident
    drag_friction(page, 0.6, 0.8)
    assert js(page, "tdmfSlip.state.values['ground.friction']") == pytest.approx(0.8, rel=0.03)
    assert js(page, "document.getElementById('scene').getBoundingClientRect().top >= 0")


@release
def test_a_video_of_three_strides_is_saved(page):
    Select(find(page, "pace")).select_by_value("full")
    begun = page.execute_script("tdmfSlip.begin(tdmfSlip.state.values); return 0")
    press(page, "video")
    assert not find(page, "video").is_enabled()
    wait(page, "tdmfSlip.video.saved", "the video")
    saved = js(page, "tdmfSlip.video.saved")
    assert saved["type"] in ("webm", "mp4") and saved["size"] > 5000
    assert js(page, "tdmfSlip.run.outputs['stride.count']") >= begun + 3
    assert find(page, "video").is_enabled() and find(page, "video").text == "Save a video"


# ---- what a person does ------------------------------------------------------------------------------------


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
    type_value(used_page, "body.external_fx", "-5")  # which is beyond the slider's reach
    control = "tdmfSlip.controls.all.get('body.external_fx')"
    low, high, value = js(used_page, f"[{control}.reach.low, {control}.reach.high, {control}.sliderValue()]")
    assert low < -5 < high and value == pytest.approx(-5, rel=0.02)


def test_a_filter_shows_the_parameters_that_it_names(used_page):
    visible = "[...document.querySelectorAll('.control:not([hidden]) input[type=text]')].map((f) => f.name)"
    field = find(used_page, "filter")
    center(used_page, field)
    field.send_keys("mass")
    names = js(used_page, visible)
    assert {"body.mass", "foot.mass"} <= set(names) and len(names) < 12
    field.send_keys(Keys.BACKSPACE * 4)
    assert len(js(used_page, visible)) > 30


def test_the_pace_says_how_fast_it_is(used_page):
    """The full pace is that of 80 kg on a spring of 20 kN/m; the other one slows stances."""
    full = math.sqrt(20000 / 80)
    Select(find(used_page, "pace")).select_by_value("full")
    assert find(used_page, "pace-text").text == f"each second shows {full:.3g} √(m/k) of the run"
    Select(find(used_page, "pace")).select_by_value("stance")
    said = f"each second shows {full:.3g} √(m/k) of a flight, {full / 10:.3g} √(m/k) of a stance"
    assert find(used_page, "pace-text").text == said


def test_no_gait_blames_what_was_changed(driver, address):
    open_page(driver, address, "#ground.slope=40deg")
    press(driver, "find")
    wait(driver, f"{hint('gait-hint')}.startsWith('No gait')", "the reason")
    text = find(driver, "gait-hint").text
    assert "friction" not in text and text.endswith("With ground.slope = 40°.")
    driver.execute_script("tdmfSlip.choose({ name: 'ice', values: { 'ground.friction': 0 } })")
    press(driver, "find")
    wait(driver, f"{hint('gait-hint')}.includes('none is isolated')", "the other reason")


@pytest.mark.parametrize("end", [-50, 50], ids=["no patch", "patch"])
def test_a_patch_is_drawn_and_has_no_gait(driver, address, end):
    patch = f"ground.patch_begin=-50&ground.patch_end={end}&ground.patch_friction=0.05"
    open_page(driver, address, f"#ground.friction=1&{patch}")
    wait(driver, f"Boolean({hint('gait-hint')}.match(/^(Gait|No gait)/))", "the gait or the reason")
    driver.execute_script("tdmfSlip.view.draw()")
    shown = driver.execute_script(COLOURED_PIXELS)
    text = find(driver, "gait-hint").text
    if end == 50:
        assert (
            shown > 200
            and text.startswith("No gait was searched for: on a slippery patch")
            and "apex" not in text
        )
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


# ---- races -------------------------------------------------------------------------------------------------


BOTH = "[tdmfSlip.run, tdmfSlip.race.rival]"
STATUS = "document.getElementById('race-text').value"


def to_the_line(driver):
    wait(driver, "tdmfSlip.race.winner !== null", "the winner")
    assert not js(driver, "tdmfSlip.player.running")


def speeds(driver):
    return js(driver, f"{BOTH}.map(({{ outputs }}) => outputs['stride.speed'])")


def begin(driver, own, rival):
    for ident, text in (("race-own", own), ("race-rival", rival)):
        find(driver, ident).clear()
        find(driver, ident).send_keys(text)
    press(driver, "race")


def test_a_race_on_request(page):
    press(page, "race")
    wait(page, "tdmfSlip.race.on", "the start")
    begun = js(page, f"{BOTH}.map((run) => run.trail.length ? 0 : run.outputs['com.x'])")
    assert begun == pytest.approx([0, 0], abs=1e-12)
    to_the_line(page)
    gaits = [tdmf_slip.find_gait({"ground.friction": friction}) for friction in (0.43, 10)]
    assert speeds(page) == pytest.approx([gait.stride["speed"] for gait in gaits], rel=1e-7)
    times = js(page, f"{BOTH}.map((run) => run.time)")
    assert times[0] == pytest.approx(times[1], rel=1e-12)
    lead = js(page, "tdmfSlip.race.margin")
    behind = 100 * (1 - gaits[1].stride["speed"] / gaits[0].stride["speed"])
    assert js(page, "tdmfSlip.race.winner") == 0 and lead == pytest.approx(behind, abs=0.5)
    assert js(page, f"{STATUS}") == f"Friction 0.43 wins over 100 l₀ by {lead:.3g} l₀."
    seen = page.execute_script(
        f"const {{ view, surface }} = tdmfSlip.view.scene; return [surface.width, ...{BOTH}.map((run) =>"
        "view.x(run.outputs['com.x']))]"
    )
    assert 0 < seen[2] < seen[1] < seen[0]


def test_a_race_by_address_is_shared_by_address(driver, address):
    open_page(driver, address, "#ground.friction=0.43&race=10")
    wait(driver, "tdmfSlip.race.on", "the start")
    assert js(driver, "tdmfSlip.race.frictions") == [0.43, 10]
    wait(driver, "location.hash.includes('leg.angle') && location.hash.includes('race=10')", "the address")
    Select(find(driver, "preset")).select_by_index(3)
    assert not js(driver, "tdmfSlip.race.on")
    wait(driver, "!location.hash.includes('race')", "the address without a race")


def test_what_is_changed_in_a_race_is_changed_for_both(page):
    press(page, "race")
    wait(page, "tdmfSlip.race.on", "the start")
    page.execute_script("tdmfSlip.player.play(false); tdmfSlip.set('body.external_fx', -0.001)")
    page.execute_script("tdmfSlip.player.advanceBy(() => tdmfSlip.run.advance(5))")
    works = js(page, f"{BOTH}.map(({{ outputs }}) => outputs['energy.external_work'])")
    shifts = js(page, f"{BOTH}.map(({{ outputs }}) => outputs['body.x'])")
    assert len(works) == 2 and all(work < -1e-3 * 4 for work in works) and min(shifts) > 4
    page.execute_script("tdmfSlip.set('ground.friction', 0.3)")
    assert js(page, "tdmfSlip.race.frictions") == [0.3, 10]
    page.execute_script("document.getElementById('restart').click(); tdmfSlip.player.play(false)")
    assert js(page, f"{BOTH}.map((run) => run.time)") == [0, 0] and js(page, "tdmfSlip.race.on")
    page.execute_script("tdmfSlip.set('leg.angle', 1)")
    assert not js(page, "tdmfSlip.race.on")


def test_a_race_against_no_number_is_refused_where_it_is_seen(page):
    begin(page, "0.43", "abc")
    wait(page, "!document.getElementById('problem').hidden", "the reason")
    assert sentence(page) == "No race: ground.friction is no number: allowed from 0 to 1000000"
    top, bottom, height = page.execute_script(
        "const { top, bottom } = document.getElementById('problem').getBoundingClientRect();"
        "return [top, bottom, innerHeight]"
    )
    assert 0 <= top < bottom <= height
