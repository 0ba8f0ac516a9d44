"""Two runners race on the live page: on request, by address, at a desk and on a phone."""

import live_pages
import pytest
import tdmf_slip
from conftest import release
from live_pages import find, js, open_page, play, press, sentence, wait
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.select import Select

built, address, driver, page = live_pages.built, live_pages.address, live_pages.driver, live_pages.page

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


@release
def test_restart_begins_the_race_anew_and_its_button_ends_it(page):
    begin(page, "0.3", "1,2")
    wait(page, "tdmfSlip.race.on && tdmfSlip.race.rival.time > 3", "the race")
    times = page.execute_script(
        "document.getElementById('restart').click(); tdmfSlip.player.play(false);"
        f"return {BOTH}.map((run) => run.time)"
    )
    assert times == [0, 0] and js(page, "tdmfSlip.race.frictions") == [0.3, 1.2]
    press(page, "race")
    assert find(page, "race").text == "Race" and not js(page, "tdmfSlip.race.on")


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


@release
def test_a_race_without_a_gait_says_why_and_all_goes_on(page):
    play(page, True)
    begin(page, "0.43", "-1")
    wait(page, "!document.getElementById('problem').hidden", "the reason")
    assert sentence(page).startswith("No race: ground.friction = -1 is refused")
    assert js(page, "tdmfSlip.race.on") is False
    assert js(page, "tdmfSlip.player.running")
    find(page, "race-rival").send_keys(Keys.BACKSPACE * 2, "10")
    press(page, "race")
    wait(page, "tdmfSlip.race.on", "the start")
    assert sentence(page) == ""
