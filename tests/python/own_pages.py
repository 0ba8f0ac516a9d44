"""Pages of users' own, built once for all tests, and loaded."""

import functools
import shutil
import tempfile
from pathlib import Path

import pytest
import tdmf_slip
from conftest import ROOT, locked
from page_runs import compiler
from tdmf_slip.building.build import derived
from tdmf_slip.building.compilers import Compiler
from tdmf_slip.building.sources import page_in
from tdmf_slip.builds import TABLE

BUILT = ROOT / "build" / "own_pages"
TWO_LANES = {2: ("TDMF_HAS_TWO_LANES", ())}
"""Lanes of these builds. Those of four and eight compile much longer; test_page_batch has them."""


def build_quickly(page, folder, unit):
    """Build a page, without what takes a compiler long."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", " ".join(compiler()))
        patch.setattr(Compiler, "lanes", TWO_LANES)
        tdmf_slip.build(page, folder, unit=unit)


def loaded(path, unit=False, cache={}):  # noqa: B006
    """The model of the page in a file, built once, on request with its FMI units."""
    if (path, unit) not in cache:
        page = page_in(path)
        table, _ = derived(page)
        folder = BUILT / f"{table['c_name']}-{table['id']}"
        with locked("own_pages"):
            if not (folder / TABLE).exists() or (unit and not any(folder.glob("*.fmu"))):
                for old in BUILT.glob(f"{table['c_name']}-*"):
                    if old != folder:
                        shutil.rmtree(old)
                build_quickly(page, folder, unit)
        cache[path, unit] = tdmf_slip.load_model(folder)
    return cache[path, unit]


@functools.cache
def template(name, **start):
    """The model of what `new` writes, with its units: all tests share a build of each template."""
    return loaded(tdmf_slip.new(Path(tempfile.mkdtemp(), name), **start) / "page.py", unit=True)


def my_ball():
    return template("my_ball", start="scratch")


def my_runner():
    return template("my_runner")
