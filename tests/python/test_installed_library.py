"""A small C program against the installed library, found by CMake and by pkg-config."""

import os
import re
import shutil

import pytest
from conftest import ROOT, succeed

CONSUMER = ROOT / "tests" / "consumer"


SAYS = {
    "strides": "+0-, speed 1.033652, cost of transport 0.366586",
    "strides_shared": "+0-, speed 1.033652, cost of transport 0.366586",
    "own_solver": "10 strides, the last +0-0+ at speed 1.060856, t = 250.00146",
    "rough_ground": "stride,x,ground,word,speed",
    "population": "200 of 200 runners are back on the gait\n"
    "the ground of the page runner may be rough\nthe ground of the page classic_slip cannot be rough",
    "trajectory": "t = 5, x = 5.3100, y = 1.2935, normal force 0.0000",
    "derivatives": "d com.y / d leg.damping = 0.11934, by differences 0.11934",
    "gait": "20 strides closed on the way to the gait\n+0-0+ at 1.060856 m/s, largest eigenvalue 0.8556",
    "page": "library package: touchdown_angle from -1.5708 to 1.5708 rad\ntouchdown_angle = 2 is",
    "law": "runner 10 begins with touchdown angle 0.6991 rad",
}
"""First words of each program's output."""


def test_find_package(installed_library, tmp_path):
    succeed("cmake", "-S", CONSUMER, "-B", tmp_path, f"-DCMAKE_PREFIX_PATH={installed_library}")
    succeed("cmake", "--build", tmp_path)
    for program, says in SAYS.items():
        assert succeed(tmp_path / program).startswith(says)


def test_every_function_stands_in_a_program():
    headers, programs = ROOT / "c_core" / "include", [*CONSUMER.glob("*.c"), *ROOT.glob("examples/*.c")]
    text = "".join(header.read_text() for header in headers.rglob("*.h"))
    functions = set(re.findall(r"^TDMF_API [^(]*?(\w+)\(", text, re.MULTILINE))
    called = "".join(program.read_text() for program in programs)
    assert 40 < len(functions) <= 60
    assert not [name for name in sorted(functions) if not re.search(rf"\b{name}\(", called)]


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
