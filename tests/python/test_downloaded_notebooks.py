"""The guides as notebooks: readable anywhere, run where only the wheel is, from an empty folder."""

import html
import json
import os
import pathlib
import re
import shutil
import sys

import pytest
from conftest import ROOT, release, succeed

GUIDES = sorted(
    path.stem
    for path in (ROOT / "documentation" / "guides").glob("*.md")
    if "{code-cell}" in path.read_text()
)
"""Guides that are notebooks. One that builds a folder by shell commands is none."""
EXECUTE = (
    "import sys, nbformat, nbclient; book = nbformat.read(sys.argv[1], 4);"
    "nbclient.NotebookClient(book, timeout=600, resources={'metadata': {'path': sys.argv[2]}}).execute();"
    "import tdmf_slip; print(tdmf_slip.__file__)"
)
sys.path.insert(0, str(ROOT / "documentation" / "extensions"))


@pytest.fixture(scope="module")
def notebooks(site):
    """Path of the notebook that each guide downloads as."""
    return {path.stem: path for path in site.glob("_downloads/*/*.ipynb")}


def cells(notebook, kind):
    content = json.loads(notebook.read_text(encoding="utf-8"))
    return [cell for cell in content["cells"] if cell["cell_type"] == kind]


def test_every_notebook_reads_without_sphinx(notebooks):
    assert sorted(notebooks) == GUIDES
    pictures, texts = 0, 0
    for name, path in notebooks.items():
        for cell in cells(path, "markdown"):
            text, attached = "".join(cell["source"]), cell.get("attachments", {})
            texts += 1
            assert not re.search(r"^```\{|\{[\w-]+\}`", text, re.MULTILINE), (name, text)
            for label, target in re.findall(r"\[([^\]]*)\]\(([^)]+)\)", text):
                assert label and target.startswith(("https://", "attachment:", "#")), (name, label, target)
            named = set(re.findall(r"\(attachment:([^)]+)\)", text))
            assert named == set(attached), name
            pictures += len(named)
    assert texts > 80 and pictures >= 18


@release
@pytest.mark.parametrize("name", GUIDES)
def test_a_notebook_runs_from_an_empty_folder_with_the_wheel_alone(
    environment, wheel, tmp_path, name, notebooks
):
    installed = environment.install(wheel)
    needed = {shutil.which(tool) and str(pathlib.Path(shutil.which(tool)).parent) for tool in ("cc", "bash")}
    variables = installed | {"PATH": os.pathsep.join([installed["PATH"], *filter(None, needed)])}
    folder = tmp_path / "empty"
    folder.mkdir()
    command = (environment.programs / "python", "-c", EXECUTE, notebooks[name], folder)
    said = succeed(*command, env=variables, cwd=tmp_path)
    assert said.splitlines()[-1].startswith(str(environment.folder))


# ---- what a page shows of an output is what was printed ----


def outputs(site, page):
    """Outputs that the page shows."""
    text = (site / "guides" / f"{page}.html").read_text(encoding="utf-8")
    found = re.findall(r'<div class="output stream[^"]*">.*?<pre>(.*?)</pre>', text, re.DOTALL)
    return [html.unescape(re.sub(r"<[^>]+>", "", one)).strip() for one in found]


def test_the_start_page_shows_what_the_command_prints(command, site):
    status, out, _ = command("gait", "--friction", "0.43")
    assert status == 0 and out.count("\n") > 15
    shown = [one for one in outputs(site, "start") if one.startswith("word ")]
    assert len(shown) == 1
    numbers = re.compile(r"-?\d\.?\d*(?:e-\d+)?")
    assert numbers.sub("#", shown[0]) == numbers.sub("#", out.strip())
    for one, other in zip(shown[0].splitlines()[:-2], out.splitlines()[:-2], strict=False):
        assert one == other or one.startswith("apex."), (one, other)


def table_of_validation(site):
    """The table of `validate` on the page of the paper."""
    (table,) = [one for one in outputs(site, "paper") if one.startswith("friction ")]
    return table


def test_validation_on_the_paper_page_meets_all_that_is_recorded(site):
    table = table_of_validation(site)
    gaits = table.splitlines()[2:7]
    assert all(row.split()[-2:] == ["same", "words"] for row in gaits)
    assert "all 135 recorded values are met" in table
