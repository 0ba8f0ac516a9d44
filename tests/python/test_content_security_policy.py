"""The policy in the site's pages, in Chromium: theirs keeps it, and nothing foreign gets past it."""

import shutil
import sys

import pytest
from conftest import ROOT, some_of

sys.path.insert(0, str(ROOT / "documentation" / "live"))
sys.path.insert(0, str(ROOT / "documentation" / "extensions"))
pytest.importorskip("sphinx", reason="NOT TESTED: the site, Sphinx is not installed")
pytest.importorskip("furo")

KINDS = {
    "the first page": "index.html",
    "a guide with pictures and equations": "guides/paper.html",
    "a guide with a table of variables": "reference/variables.html",
    "a page with a graph": "development/architecture.html",
    "a reference of Python": "reference/python/index.html",
    "a reference of C": "reference/c/run.html",
    "the command's help": "reference/command_line.html",
    "sources": "_modules/index.html",
    "the index": "genindex.html",
    "a search": "search.html?q=friction",
    "the index of modules": "py-modindex.html",
}
"""A page of each kind."""


def where(pages):
    """Some pages, or with --release all, by a server and as a file."""
    return [("by a server", page) for page in pages] + [("by file://", page) for page in some_of(pages, 2)]


WATCH = """
globalThis.violations = [];
document.addEventListener("securitypolicyviolation", (event) =>
  violations.push(`${event.violatedDirective}: ${event.blockedURI}`));
"""
"""Runs before any script of a page, on the browser's own account."""
INJECT = """
const script = document.createElement("script");
script.textContent = "globalThis.injected = 'script'";
document.body.append(script);
const picture = document.createElement("div");
picture.innerHTML = `<img src="data:," onerror="globalThis.injected = 'attribute'">`;
document.body.append(picture);
const elsewhere = document.createElement("script");
elsewhere.src = "data:text/javascript,globalThis.injected = 'address'";
document.body.append(elsewhere);
setTimeout(() => {  // what the driver itself evaluates is exempt
  try {
    globalThis.injected = eval("'text'");
  } catch {
    globalThis.refused = true;
  }
});
"""


@pytest.fixture(scope="module")
def driver(request, site):
    pytest.importorskip("selenium")
    if not (shutil.which("chromium") and shutil.which("chromedriver")):
        pytest.skip("needs Debian's chromium and chromium-driver")
    from browser import script_first

    with script_first(request.getfixturevalue("browsers")(1280, 900), WATCH) as driver:
        yield driver


@pytest.fixture(scope="module")
def address(request, site):
    from browser import served

    if request.param == "by file://":
        yield site.as_uri()
        return
    with served(site) as address:
        yield address


def problems(driver):
    """Violations of the policy, and other complaints of the page. A page in a file may lack summaries."""
    said = [entry["message"] for entry in driver.get_log("browser")]
    if driver.current_url.startswith("file:"):
        said = [text for text in said if "Content Security Policy" in text]
    return [*driver.execute_script("return violations"), *said]


def opened(driver, address, page):
    """The driver with the page loaded whole, and nothing of it refused."""
    from browser import wait

    driver.get("about:blank")
    driver.get_log("browser")
    driver.get(f"{address}/{page}")
    wait(driver, "document.readyState === 'complete'")
    policies = "document.querySelectorAll('meta[http-equiv=Content-Security-Policy]').length"
    assert driver.execute_script(f"return {policies}") == 1, f"{page} has no policy, or does not exist"
    return driver


@pytest.mark.parametrize(("address", "kind"), where(KINDS), indirect=["address"])
def test_a_page_within_its_policy_has_its_styles_its_pictures_and_the_theme_s_script(driver, address, kind):
    from browser import wait

    opened(driver, address, KINDS[kind])
    assert problems(driver) == []
    assert driver.execute_script("return document.body.dataset.theme") == "auto"
    links = "[...document.querySelectorAll('link[rel=stylesheet]')]"
    assert driver.execute_script(f"return {links}.length") >= 4
    assert driver.execute_script(f"return {links}.every((link) => link.sheet !== null)")
    assert driver.execute_script(
        "return getComputedStyle(document.querySelector('.sidebar-drawer')).display"
    ) != ("inline")
    driver.execute_script("for (const picture of document.images) picture.loading = 'eager'")
    wait(driver, "[...document.images].every((picture) => picture.complete)", "the pictures")
    assert driver.execute_script("return [...document.images].every((picture) => picture.naturalWidth > 0)")
    if "?" in KINDS[kind]:
        wait(driver, "document.querySelectorAll('#search-results li').length > 3", "what is found")


@pytest.mark.parametrize(
    ("address", "page"), where(some_of(["live.html", *KINDS.values()], 4)), indirect=["address"]
)
def test_an_injected_script_does_not_run(driver, address, page):
    opened(driver, address, page)
    if page == "live.html" and address.startswith("file"):
        driver.execute_script("violations.length = 0")  # its modules need a server, with a policy or without
    driver.execute_script(INJECT)
    from browser import wait

    wait(driver, "violations.length >= 4 && globalThis.refused", "four refusals")
    assert driver.execute_script("return globalThis.injected") is None
    assert driver.execute_script("return violations.map((text) => text.split(':')[0]).sort()") == [
        "script-src",
        "script-src-attr",
        "script-src-elem",
        "script-src-elem",
    ]


def test_the_live_page_runs_within_its_policy(driver, site):
    from browser import open_page, served

    with served(site) as address:
        driver.get_log("browser")
        open_page(driver, address)
        assert problems(driver) == []


# ---- the build ----


def test_every_page_has_the_policy_before_anything_that_it_rules(site):
    from content_security_policy import Scripts, policy

    pages = sorted(site.rglob("*.html"))
    for path in pages:
        text = path.read_text(encoding="utf-8")
        head, rest = text.split("Content-Security-Policy", 1)
        assert "<script" not in head and "<link" not in head and "<style" not in head, path.name
        if path.name != "live.html":
            assert rest.startswith('" content="' + policy().replace("'", "&#39;") + '"'), path.name
        else:
            assert "'wasm-unsafe-eval'" in rest.split(">")[0] and Scripts(text).inline == []
    assert len(pages) > 150


@pytest.mark.parametrize(
    ("content", "named"),
    [
        ("<script>alert(1)</script>", "alert(1)"),
        ('<p onclick="alert(2)">', 'onclick="alert(2)"'),
        ('<a href="javascript:alert(3)">', "javascript:alert(3)"),
        ("<SCRIPT >alert(4)</SCRIPT\n>", "alert(4)"),
        ('<svg/onload = "alert(5)">', 'onload="alert(5)"'),
        ("<a href=' &#106;ava&#115;cript:alert(6)'>", "javascript:alert(6)"),
    ],
)
def test_a_page_whose_script_would_not_run_fails_the_build(tmp_path, content, named):
    from content_security_policy import check, theme_scripts
    from sphinx.errors import ExtensionError

    allowed = "".join(f"<script>{script}</script>" for script in theme_scripts())
    (tmp_path / "page.html").write_text(f'<script src="a.js"></script>{allowed}<p style="color: red">')
    check(tmp_path)
    (tmp_path / "page.html").write_text(allowed + content)
    with pytest.raises(ExtensionError, match=r"page\.html") as refused:
        check(tmp_path)
    assert named in str(refused.value)
