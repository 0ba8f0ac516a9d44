"""A small C program against the installed library, found by CMake and by pkg-config."""

import os
import pathlib
import shutil

import pytest
from conftest import succeed

CONSUMER = pathlib.Path(__file__).resolve().parents[1] / "consumer"


SAYS = {
    "strides": "+0-, speed 1.033652, cost of transport 0.366586",
    "strides_shared": "+0-, speed 1.033652, cost of transport 0.366586",
    "own_solver": "10 strides, the last +0-0+ at speed 1.060856, t = 250.00146",
    "runner": "tdmf_slip 0.1.0: touchdown at t = 12.02",
    "rough_ground": "stride,x,ground,word,speed",
    "population": "200 of 200 runners are back on the gait",
}
"""What each program prints."""


def test_find_package(installed_library, tmp_path):
    succeed("cmake", "-S", CONSUMER, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={installed_library}")
    succeed("cmake", "--build", tmp_path)
    for program, says in SAYS.items():
        assert succeed(tmp_path / program).startswith(says)


@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="pkg-config is not installed")
@pytest.mark.parametrize(
    ("program", "package"), [("strides", "tdmf_slip"), ("population", "tdmf_slip_ensemble")]
)
def test_pkg_config(installed_library, tmp_path, program, package):
    (folder,) = {path.parent for path in installed_library.rglob(f"{package}.pc")}
    environment = os.environ | {"PKG_CONFIG_PATH": str(folder)}
    flags = succeed("pkg-config", "--cflags", "--libs", package, env=environment).split()
    succeed("cc", "-std=c99", CONSUMER / f"{program}.c", *flags, "-o", tmp_path / program)
    assert succeed(tmp_path / program).startswith(SAYS[program])
