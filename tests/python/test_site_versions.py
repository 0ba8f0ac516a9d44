"""Versions of the site side by side: two, built by the site's own extensions, and one list of both."""

import json
import pathlib
import shutil
import sys

import pytest
from conftest import succeed

DOCUMENTATION = pathlib.Path(__file__).resolve().parents[2] / "documentation"
sys.path.insert(0, str(DOCUMENTATION / "live"))
pytest.importorskip("sphinx", reason="NOT TESTED: the site, Sphinx is not installed")
pytest.importorskip("furo")
pytest.importorskip("selenium")
if not (shutil.which("chromium") and shutil.which("chromedriver")):
    pytest.skip("needs Debian's chromium and chromium-driver", allow_module_level=True)

from browser import served, wait  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.support.select import Select  # noqa: E402

PAGES = {"0.1.0": ("index", "guides/old"), "0.2.0": ("index", "guides/old", "guides/new")}
"""The keys are versions of the site."""
SETTINGS = f"""
import sys
sys.path.insert(0, {str(DOCUMENTATION / "extensions")!r})
project = "TDMF-SLIP"
extensions = ["content_security_policy", "page_description", "versions"]
templates_path = [{str(DOCUMENTATION / "templates")!r}]
html_static_path = [{str(DOCUMENTATION / "static")!r}]
html_theme = "furo"
html_sidebars = {{"**": ["versions.html"]}}
"""
SHOWN = "!document.querySelector('.versions').hidden"


def build(folder, version, listed):
    sources = folder / "sources" / version
    for page in PAGES[version]:
        path = sources / f"{page}.rst"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f":orphan:\n\n{page} of {version}\n{40 * '='}\n", encoding="utf-8")
    own = f"version = release = {version!r}\nversions_file = {listed!r}\n"
    (sources / "conf.py").write_text(SETTINGS + own, encoding="utf-8")
    succeed(sys.executable, "-m", "sphinx", "--quiet", "--fail-on-warning", sources, folder / version)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("versions")
    for version in PAGES:
        build(folder, version, "../versions.json")
    return folder


@pytest.fixture(scope="module")
def browser(folder, browsers):
    with served(folder) as address:
        yield browsers(1280, 900), address


def list_versions(folder, *versions):
    entries = [{"version": version, "address": f"{version}/index.html"} for version in versions]
    (folder / "versions.json").write_text(json.dumps(entries), encoding="utf-8")


def choose(driver, version):
    Select(driver.find_element(By.CSS_SELECTOR, ".versions select")).select_by_visible_text(version)


def test_an_old_version_leads_to_the_same_page_of_a_later_one(folder, browser):
    driver, address = browser
    list_versions(folder, "0.2.0", "0.1.0")
    driver.get(f"{address}/0.1.0/guides/old.html")
    wait(driver, SHOWN, "the menu")
    menu = Select(driver.find_element(By.CSS_SELECTOR, ".versions select"))
    assert [option.text for option in menu.options] == ["0.2.0", "0.1.0"]
    assert menu.first_selected_option.text == "0.1.0"
    choose(driver, "0.2.0")
    wait(driver, "location.pathname === '/0.2.0/guides/old.html'", "the later version")
    assert "of 0.2.0" in driver.find_element(By.TAG_NAME, "h1").text


def test_a_page_that_the_other_version_lacks_leads_to_its_first_page(folder, browser):
    driver, address = browser
    list_versions(folder, "0.2.0", "0.1.0")
    driver.get(f"{address}/0.2.0/guides/new.html")
    wait(driver, SHOWN, "the menu")
    choose(driver, "0.1.0")
    wait(driver, "location.pathname === '/0.1.0/index.html'", "the other version's first page")


@pytest.mark.parametrize("versions", [("0.1.0",), ("0.2.0", "0.3.0")], ids=["alone", "not listed"])
def test_there_is_no_menu_where_there_is_nothing_to_choose(folder, browser, versions):
    driver, address = browser
    list_versions(folder, *versions)
    driver.get("about:blank")
    driver.get(f"{address}/0.1.0/index.html")
    wait(driver, "performance.getEntriesByType('resource').some((e) => e.name.endsWith('versions.json'))")
    wait(driver, "new Promise((done) => setTimeout(() => done(true), 200))", "what comes of the list")
    assert driver.execute_script(f"return {SHOWN}") is False


def test_a_site_without_a_list_asks_for_none(tmp_path):
    build(tmp_path, "0.1.0", "")
    text = (tmp_path / "0.1.0" / "index.html").read_text(encoding="utf-8")
    assert "versions.js" not in text and 'class="versions"' not in text
