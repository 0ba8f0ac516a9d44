"""The examples in docstrings of what users call first: each has one, and each prints what it says."""

import doctest
import inspect
import shutil

import matplotlib.pyplot as plt
import own_pages
import pytest
import tdmf_slip
from conftest import RELEASE

FUNCTIONS = {
    name: getattr(tdmf_slip, name)
    for name in tdmf_slip.__all__
    if inspect.isfunction(getattr(tdmf_slip, name))
}
WITH_EXAMPLE = {name for name, thing in FUNCTIONS.items() if ">>>" in (inspect.getdoc(thing) or "")}
OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
SLOW = {"continue_curves", "prove", "prove_attraction", "prove_border", "rare_falls", "validate"}
"""Functions whose examples take seconds or a minute; `scripts/test --release` runs them."""


def test_every_function_has_an_example():
    assert len(FUNCTIONS) > 20 and set(FUNCTIONS) - WITH_EXAMPLE == set()


@pytest.fixture
def build_once(monkeypatch):
    """Let `tdmf_slip.build` hand out the build that all tests share."""
    shared = own_pages.my_ball().folder
    monkeypatch.setattr(tdmf_slip, "build", lambda page: shutil.copytree(shared, page / "build"))


@pytest.mark.parametrize("name", sorted(WITH_EXAMPLE))
def test_an_example_prints_what_it_says(name, tmp_path, monkeypatch, request):
    if name in SLOW and not RELEASE:
        pytest.skip("takes long: scripts/test --release")
    if name.startswith("prove"):
        pytest.importorskip("flint", reason="NOT TESTED: examples of proofs, python-flint is missing")
    monkeypatch.chdir(tmp_path)
    if name in ("build", "load_model"):
        request.getfixturevalue("build_once")
    found = doctest.DocTestFinder(recurse=False).find(FUNCTIONS[name], name, globs={})
    (example,) = found
    said = []
    results = doctest.DocTestRunner(optionflags=OPTIONS).run(example, out=said.append)
    plt.close("all")
    assert results.attempted > 0 and results.failed == 0, "".join(said)
