"""A small C program against the installed library, found by CMake and by pkg-config."""

import os
import pathlib
import shutil
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONSUMER = ROOT / "tests" / "consumer"


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Folder into which `cmake --install` has put the library."""
    build = tmp_path_factory.mktemp("library")
    prefix = build / "prefix"
    run("cmake", "-S", ROOT, "-B", build, "-DTDMF_SLIP_BUILD_FMU=OFF")
    run("cmake", "--build", build)
    run("cmake", "--install", build, "--component", "library", "--prefix", prefix)
    return prefix


SAYS = {
    "strides": "+0-, speed 1.033110, cost of transport 0.364532",
    "runner": "tdmf_slip 0.1.0: touchdown at t = 11.90",
    "crowd": "200 of 200 runners are back on the gait",
}
"""What each program prints."""


def test_the_readme_shows_one_of_them():
    assert (CONSUMER / "strides.c").read_text() in (ROOT / "README.md").read_text(encoding="utf-8")


def test_find_package(installed, tmp_path):
    run("cmake", "-S", CONSUMER, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={installed}")
    run("cmake", "--build", tmp_path)
    for program, says in SAYS.items():
        assert run(tmp_path / program).startswith(says)


@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="pkg-config is not installed")
@pytest.mark.parametrize(("program", "package"), [("strides", "tdmf_slip"), ("crowd", "tdmf_slip_ensemble")])
def test_pkg_config(installed, tmp_path, program, package):
    (folder,) = {path.parent for path in installed.rglob(f"{package}.pc")}
    environment = os.environ | {"PKG_CONFIG_PATH": str(folder)}
    flags = run("pkg-config", "--cflags", "--libs", package, env=environment).split()
    run("cc", "-std=c99", CONSUMER / f"{program}.c", *flags, "-o", tmp_path / program)
    assert run(tmp_path / program).startswith(SAYS[program])
