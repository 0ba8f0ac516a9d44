"""The folder that a unit is unpacked into: forks, cleaned temporary files, pickles; no working directory."""

import pathlib
import pickle
import shutil
import sys

import pytest
import tdmf_slip
from conftest import run_python
from tdmf_slip.fmu.fmu import Fmu

STRIDE = "assert tdmf_slip.simulate(strides=1).attrs['stride.count'] == 1"
FORKS = f"""
import multiprocessing, os, shutil, sys
import tdmf_slip

def stride():
    {STRIDE}

process = multiprocessing.get_context("fork").Process(target=stride)
process.start()  # has nothing to take over, and unpacks the unit itself
process.join()
assert process.exitcode == 0
stride()
folder = tdmf_slip.load_fmu().folder
if os.fork() == 0:
    stride()
    sys.exit(0)  # an end in order, with all that Python does then
assert os.wait()[1] == 0
assert os.path.isdir(folder)
if os.fork() == 0:
    shutil.rmtree(folder)  # as if the parent had ended
    stride()
    sys.exit(0)
assert os.wait()[1] == 0
stride()
"""


def run(program, folder, temporary):
    temporary.mkdir()
    surroundings = {"cwd": folder, "env": {"TMPDIR": str(temporary), "PATH": ""}}
    return run_python("-W", "error", "-c", program, **surroundings)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")
def test_a_fork_leaves_the_folder_to_its_parent_and_nothing_behind(tmp_path):
    done = run(FORKS, tmp_path, tmp_path / "temporary")
    assert (done.returncode, done.stderr) == (0, "")
    assert list((tmp_path / "temporary").iterdir()) == []


@pytest.fixture
def own_fmu():
    """A unit that no other test has unpacked."""
    return Fmu(tdmf_slip.fmu_path())


@pytest.mark.parametrize("interface", ["me", "cs"])
def test_a_unit_is_unpacked_again_where_temporary_files_are_cleaned(own_fmu, interface):
    for left in ("", "binaries"):
        tdmf_slip.simulate(strides=1, interface=interface, fmu=own_fmu)
        before = pathlib.Path(own_fmu.folder)
        shutil.rmtree(before / left)
        assert tdmf_slip.simulate(strides=1, interface=interface, fmu=own_fmu).attrs["stride.count"] == 1
        assert before != pathlib.Path(own_fmu.folder)


def test_a_pickled_unit_has_a_folder_of_its_own(own_fmu):
    folder = own_fmu.folder
    assert folder.encode() not in pickle.dumps(own_fmu)
    other = pickle.loads(pickle.dumps(own_fmu))
    assert other.folder != folder == own_fmu.folder
    assert tdmf_slip.simulate(strides=1, fmu=other).attrs["stride.count"] == 1


@pytest.mark.skipif(sys.platform == "win32", reason="Windows keeps a working directory")
def test_a_working_directory_that_is_gone_is_named(tmp_path):
    program = f"""
import os
os.mkdir("gone")
os.chdir("gone")
os.rmdir("../gone")
import tdmf_slip
try:
    {STRIDE}
except tdmf_slip.RunError as problem:
    print(problem)
"""
    done = run(program, tmp_path, tmp_path / "temporary")
    assert done.stdout == (
        "the working directory cannot be used: No such file or directory; change to one that is there\n"
    ), done.stderr
