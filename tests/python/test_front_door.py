"""Pages that people meet first: README, home page, search, gallery and glossary."""

import csv
import io
import os
import pathlib
import re
import shutil
import sys
import tomllib
from contextlib import redirect_stdout

import pytest
from conftest import ROOT, succeed

SOURCES = ROOT / "documentation"
README = (ROOT / "README.md").read_text(encoding="utf-8")
GLOSSARY = tomllib.loads((SOURCES / "glossary.toml").read_text(encoding="utf-8"))
in_browser = pytest.mark.skipif(
    not (shutil.which("chromium") and shutil.which("chromedriver")), reason="NOT TESTED: Chromium is missing"
)
sys.path[:0] = [str(SOURCES / "extensions"), str(SOURCES / "live")]


def test_the_readme_is_short_and_begins_with_two_commands():
    assert len(README.encode()) < 5000 and README.count("\n") < 80
    first = re.search(r"```sh\n(.*?)```", README, re.DOTALL)[1].splitlines()
    assert [line.split()[0] for line in first] == ["./scripts/run", "./scripts/test"]
    assert all((ROOT / line.split()[0]).is_file() for line in first)
    for early in ("FMI", "saltation"):
        assert early not in README[: README.index("## Five lines")]
    links = [link.partition("#")[0] for link in re.findall(r"\]\(([^)]+)\)", README)]
    assert len(links) > 20
    assert [link for link in links if not link.startswith("https:") and not (ROOT / link).is_file()] == []


def test_the_five_lines_of_the_readme_print_what_it_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (code,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    (documented,) = re.findall(r"print\(.*\)  # (.*)", code)
    said = io.StringIO()
    with redirect_stdout(said):
        exec(compile(code, "README.md", "exec"), {})
    printed = said.getvalue().split()
    assert len(printed) == 3
    for one, other in zip(printed, documented.split(), strict=True):
        assert one.startswith(other.removesuffix("...")), said.getvalue()
    assert len(code.split("\n\n")) == 2 and len([line for line in code.splitlines() if line]) == 5
    assert (tmp_path / "gait.png").stat().st_size > 10_000


def test_every_command_that_is_printed_first_runs_as_printed(command):
    text = "".join((ROOT / path).read_text(encoding="utf-8") for path in ("README.md", "scripts/run"))
    lines = set(re.findall(r"^ *\.venv/bin/tdmf-slip (?!validate)(.+)$", text, re.MULTILINE))
    assert len(lines) >= 3
    for line in lines:
        arguments = [*line.split(), *(["--frames", "12"] if line.startswith("animate") else [])]
        status, _, said = command(*arguments)
        assert status == 0, (line, said)


# ---- the gallery ----


def test_the_gallery_has_every_figure_and_each_runs_live_by_names_that_there_are(command, fmu):
    text = (SOURCES / "gallery.md").read_text(encoding="utf-8")
    shown = re.findall(r"^```\{gallery-figure\} (\w+)$", text, re.MULTILINE)
    said = command.refusal("figures", "--only", "?")
    assert shown
    assert sorted(shown) == sorted(said.partition("allowed: ")[2].strip().split(", "))
    states = re.findall(r"^:live: (\S+)$", text, re.MULTILINE)
    assert len(states) >= 14
    for name in (pair.split("=")[0] for state in states for pair in state.split("&")):
        assert name in fmu.variables or name == "race", name
    guides = set(re.findall(r"^:guide: (\S+)$", text, re.MULTILINE))
    assert all((SOURCES / "guides" / f"{guide}.md").is_file() for guide in guides)


def test_each_figure_of_the_gallery_has_its_picture_and_its_data(site):
    page = (site / "gallery.html").read_text(encoding="utf-8")
    pictures, data = (set(re.findall(rf'"figures/(\w+)\.{suffix}"', page)) for suffix in ("png", "csv"))
    assert pictures == data and len(pictures) >= 22
    for name in pictures:
        assert (site / "figures" / f"{name}.png").stat().st_size > 5000, name
        rows = (site / "figures" / f"{name}.csv").read_text(encoding="utf-8").splitlines()
        assert len(rows) > 2 and len({len(row) for row in csv.reader(rows)}) == 1, name


# ---- the glossary ----


def test_every_word_that_the_live_page_marks_is_in_the_glossary():
    page = "".join(path.read_text(encoding="utf-8") for path in (SOURCES / "live/page").iterdir())
    marked = set(re.findall(r'data-term="(\w+)"', page))
    assert len(marked) >= 3 and marked <= set(GLOSSARY["live"])
    titles = [term["title"] for group in GLOSSARY.values() for term in group.values()]
    assert len(titles) == len(set(titles)) > 30
    assert all(term["text"].endswith(".") for group in GLOSSARY.values() for term in group.values())


# ---- the built pages ----


def test_every_page_describes_itself(site):
    pages = [path for path in site.rglob("*.html") if path.name != "live.html"]
    assert len(pages) > 40
    documented = {}
    for path in pages:
        text = path.read_text(encoding="utf-8")
        (description,) = re.findall(r'<meta name="description" content="([^"]*)">', text)
        assert 30 < len(description) < 260, path
        assert '<meta property="og:title" content="' in text and 'icon" href=' in text, path
        documented.setdefault(description, []).append(path)
    assert len(documented) > 20


@in_browser
@pytest.mark.parametrize(
    ("query", "page", "rank"), [("install", "install.html", 5), ("sweep", "guides/sweep.html", 1)]
)
def test_the_search_finds_guides_before_the_reference(query, page, rank, browsers, site):
    from browser import served, wait

    driver = browsers(1280, 900)
    with served(site) as address:
        driver.get(f"{address}/search.html?q={query}")
        links = "[...document.querySelectorAll('#search-results li a')].map((link) => link.pathname)"
        finished = "document.querySelector('.search-summary')?.textContent.startsWith('Search finished')"
        found = wait(driver, f"{finished} && {links}", "what was found")
        assert f"/{page}" in found[:rank], found
        assert not any("/reference/" in path for path in found[: found.index(f"/{page}")]), found


def test_nothing_says_to_install_what_is_not_published():
    """Until it is; then `INSTALL` of the site's configuration says so."""
    configuration = (SOURCES / "conf.py").read_text(encoding="utf-8")
    (install,) = re.findall(r'^INSTALL = "(.+?)"', configuration, re.MULTILINE)
    if install != "pip install .":
        return
    looked_at = [ROOT / "README.md", *SOURCES.rglob("*.md"), *(ROOT / "scripts/tdmf_slip").rglob("*.py")]
    assert len(looked_at) > 100
    wrong = re.compile(r"pip install ['\"]?tdmf[-_]slip")
    assert [path for path in looked_at if wrong.search(path.read_text(encoding="utf-8"))] == []


def test_how_to_cite_is_what_the_citation_file_says():
    citation = pytest.importorskip("citation", reason="NOT TESTED: how to cite, Sphinx is missing")
    text = citation.bibtex()
    assert text.count("@") == 2 and "doi = {10.5772/62687}" in text
    assert "author = {Or, Yizhar and Moravia, Moti}" in text and "author = {{The TDMF-SLIP authors}}" in text
    (version,) = re.findall(r"^version: (\S+)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.M)
    assert f"version = {{{version}}}" in text


@pytest.mark.parametrize("shell", ["bash", "zsh"])
def test_completion_is_as_the_install_page_says(shell):
    documented = (SOURCES / "install.md").read_text(encoding="utf-8")
    variable = f"_TDMF_SLIP_COMPLETE={shell}_source"
    assert f"{variable} tdmf-slip" in documented
    command = pathlib.Path(sys.executable).with_name("tdmf-slip")
    if not command.is_file():
        pytest.skip("NOT TESTED: completion; the command is not beside Python")
    said = succeed(command, env=os.environ | dict([variable.split("=")]))
    assert "_tdmf_slip_completion" in said and len(said) > 300
