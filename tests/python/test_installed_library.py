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
    run("cmake", "-S", ROOT, "-B", build, "-DTDMF_SLIP_BUILD_FMU=OFF", f"-DCMAKE_INSTALL_PREFIX={prefix}")
    run("cmake", "--build", build)
    run("cmake", "--install", build, "--component", "library")
    return prefix


def assert_runs(program):
    assert run(program).startswith("tdmf_slip 0.1.0: touchdown at t = 11.90")


def test_find_package(installed, tmp_path):
    run("cmake", "-S", CONSUMER, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={installed}")
    run("cmake", "--build", tmp_path)
    assert_runs(tmp_path / "runner")


@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="pkg-config is not installed")
def test_pkg_config(installed, tmp_path):
    (folder,) = {path.parent for path in installed.rglob("tdmf_slip.pc")}
    environment = os.environ | {"PKG_CONFIG_PATH": str(folder)}
    flags = run("pkg-config", "--cflags", "--libs", "tdmf_slip", env=environment).split()
    run("cc", "-std=c99", CONSUMER / "runner.c", *flags, "-o", tmp_path / "runner")
    assert_runs(tmp_path / "runner")
