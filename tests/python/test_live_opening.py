"""What the live page shows by itself: gait, figure 9, region, the word as it comes; and what explains it."""

import live_pages
import pytest
import tdmf_slip
from conftest import release
from live_pages import (
    center,
    check_console,
    drag_friction,
    find,
    hint,
    js,
    open_page,
    pointer,
    press,
    show_curve,
    wait,
)
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select

built, address, driver = live_pages.built, live_pages.address, live_pages.driver
page, used_page = live_pages.page, live_pages.used_page

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


def test_a_filter_shows_the_parameters_that_it_names(used_page):
    field = find(used_page, "filter")
    center(used_page, field)
    field.send_keys("mass")
    shown = (
        "return [...document.querySelectorAll('.control:not([hidden]) input[type=text]')].map((f) => f.name)"
    )
    names = used_page.execute_script(shown)
    assert {"body.mass", "foot.mass"} <= set(names) and len(names) < 12
    assert find(used_page, "value-body.mass").is_displayed()
    field.send_keys(Keys.BACKSPACE * 4)
    assert len(used_page.execute_script(shown)) > 30 and not find(used_page, "value-body.mass").is_displayed()


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


@pytest.mark.on_phone
def test_a_phone_shows_the_runner_then_friction_then_figure_9(driver, address):
    open_page(driver, address)
    tops = js(
        driver,
        "['scene', 'friction-slider', 'friction', 'gait', 'region'].map((ident) =>"
        "document.getElementById(ident).getBoundingClientRect().top)",
    )
    if js(driver, "innerWidth < 900"):
        assert tops == sorted(tops)


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
