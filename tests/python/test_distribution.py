"""This machine's wheel and the source distribution, installed."""

import json
import os
import shutil
import sys
import tarfile

import pytest
from conftest import ROOT, locked, release, succeed, unit_reference

UNITS = ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu")


@pytest.fixture(scope="module")
def sources(tmp_path_factory):
    """The source distribution."""
    folder = tmp_path_factory.mktemp("sources")
    make = "import sys; from scikit_build_core.build import build_sdist; build_sdist(sys.argv[1])"
    with locked("wheel"):
        succeed(sys.executable, "-c", make, folder, cwd=ROOT)
    (path,) = folder.glob("*.tar.gz")
    return path


def assert_runs(environment, variables):
    (package,) = environment.folder.glob("lib/*/site-packages/tdmf_slip")
    assert all((package / unit).is_file() for unit in UNITS)
    command = environment.programs / "tdmf-slip"
    run_by_unit = json.loads(succeed(command, "simulate", "--strides", "2", "--json", env=variables))
    gait_by_library = json.loads(succeed(command, "gait", "--friction", "0.6", "--json", env=variables))
    for stride, tolerance in ((run_by_unit["stride"], 1e-6), (gait_by_library, 1e-9)):
        assert stride["word"] == "+0-0+"
        assert stride["period"] == pytest.approx(unit_reference()["period"], rel=tolerance)


def test_the_wheel_installs_and_runs_without_a_compiler(environment, wheel):
    variables = environment.install(wheel)
    for compiler in ("cc", "gcc", "clang", "cmake", "ninja"):
        assert shutil.which(compiler, path=variables["PATH"]) is None
    assert_runs(environment, variables)


@release
def test_the_source_distribution_installs_and_runs(environment, sources):
    """The machine's compiler builds it, with CVODE where SUNDIALS is found."""
    assert_runs(environment, environment.install(sources, path=os.environ["PATH"]))


def test_the_source_distribution_is_what_git_has(sources):
    """The archive has every source, and no product of a build."""
    with tarfile.open(sources) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames() if "/" in name}
    tracked = set(succeed("git", "ls-files", cwd=ROOT).splitlines())
    assert {
        name for name in tracked if name.split("/")[0] in ("c_core", "fmu_src", "cmake", "scripts")
    } <= names
    assert not [name for name in names if name.startswith(("build/", "dist/", "results/", ".venv/"))]
