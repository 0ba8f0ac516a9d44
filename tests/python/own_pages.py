"""Pages of users' own, built once for all tests, and loaded."""

import functools
import tempfile
from pathlib import Path

import pytest
import tdmf_slip
from page_runs import built_once, compiler
from tdmf_slip.building.build import derived
from tdmf_slip.building.compilers import Compiler
from tdmf_slip.building.sources import page_in

TWO_LANES = {2: ("TDMF_HAS_TWO_LANES", ())}
"""Lanes of these builds. Those of four and eight compile much longer; test_page_batch has them."""


def build_quickly(page, folder, unit):
    """Build a page, without what takes a compiler long."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("CC", " ".join(compiler()))
        patch.setattr(Compiler, "lanes", TWO_LANES)
        tdmf_slip.build(page, folder, unit=unit)


@functools.cache
def loaded(path, unit=False):
    """The model of the page in a file, built once, on request with its FMI units."""
    page = page_in(path)
    table, _ = derived(page)
    fill = functools.partial(build_quickly, page, unit=unit)
    return tdmf_slip.load_model(built_once(table["c_name"], [table["id"], unit], fill))


@functools.cache
def template(name, **start):
    """The model of what `new` writes, with its units: all tests share a build of each template."""
    return loaded(tdmf_slip.new(Path(tempfile.mkdtemp(), name), **start) / "page.py", unit=True)


def my_ball():
    return template("my_ball", start="scratch")


def my_runner():
    return template("my_runner")
