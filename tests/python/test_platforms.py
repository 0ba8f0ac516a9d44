"""The units with every platform's binaries (build/platforms, made by ./scripts/release).

Windows runs under wine, Arm Linux under qemu, by a small importer in C (tests/platforms), and has to see what
Linux sees; the files for macOS and Arm Windows are read.
"""

import json
import pathlib
import zipfile

import fmpy
import pytest
import tdmf_slip
from binaries import Library, arm_linux, functions_of_fmi, libraries_in, windows
from conftest import QUANTITIES, ROOT, succeed, unit_reference
from fmpy.validation import validate_fmu
from tdmf_slip.builds import TABLE, host

PLATFORMS = ROOT / "build/platforms"
UNITS = {2: PLATFORMS / "TDMF_SLIP.fmu", 3: PLATFORMS / "TDMF_SLIP_FMI3.fmu"}
BINARIES = {
    2: ["linux64/TDMF_SLIP.so", "win64/TDMF_SLIP.dll", "darwin64/TDMF_SLIP.dylib"],
    3: [
        f"{processor}-{system}/TDMF_SLIP.{ending}"
        for processor in ("x86_64", "aarch64")
        for system, ending in (("linux", "so"), ("windows", "dll"), ("darwin", "dylib"))
    ],
}
HEADERS = pathlib.Path(fmpy.__file__).parent / "c-code"
REFERENCE = unit_reference()
COMPARED = [*(f"stride.{name}" for name in QUANTITIES), "apex.leg_angle", "foot.x", "energy.total"]

pytestmark = pytest.mark.skipif(
    not all(unit.is_file() for unit in UNITS.values()),
    reason="NOT TESTED: units for every platform; ./scripts/release makes them",
)


@pytest.fixture(scope="module")
def libraries(tmp_path_factory):
    """The folders into which both units are unpacked, by FMI version."""
    folders = {}
    for fmi, unit in UNITS.items():
        folders[fmi] = tmp_path_factory.mktemp("platforms")
        with zipfile.ZipFile(unit) as file:
            file.extractall(folders[fmi])
    return folders


def library(libraries, fmi, name):
    return libraries[fmi] / "binaries" / name


@pytest.mark.parametrize("fmi", UNITS)
def test_every_platform_is_there_and_nothing_else(fmi):
    with zipfile.ZipFile(UNITS[fmi]) as unit:
        names = [n.removeprefix("binaries/") for n in unit.namelist() if n.startswith("binaries/")]
        assert "sources/runner_motions.c" in unit.namelist()
    assert sorted(names) == sorted(BINARIES[fmi])
    assert validate_fmu(str(UNITS[fmi])) == []


PROCESSORS = {"linux64": {"x86_64"}, "win64": {"x86_64"}, "darwin64": {"x86_64", "aarch64"}}
"""Processors by the names that FMI 2.0 gives to platforms; the file for macOS is universal."""


@pytest.mark.parametrize("fmi", UNITS)
def test_each_library_is_for_its_processors_exports_the_standard_and_needs_only_the_system(fmi):
    found = dict(libraries_in(UNITS[fmi]))
    assert len(found) == len(BINARIES[fmi])
    for path, data in found.items():
        platform = path.split("/")[1]
        library = Library(data)
        assert library.processors == PROCESSORS.get(platform, {platform.split("-")[0]}), path
        assert library.exports == functions_of_fmi(HEADERS, fmi), path
        library.assert_needs_only_the_system()


# ---- running ------------------------------------------------------------------------------------------


def seen(libraries, fmi, name, build, before=(), ending="", environment=None):
    """Word and values that a platform's importer reads, by interface."""
    description = fmpy.read_model_description(str(UNITS[fmi]))
    references = {v.name: str(v.valueReference) for v in description.modelVariables}
    identity = description.guid if fmi == 2 else description.instantiationToken
    program = PLATFORMS / build / "tests/platforms" / f"importer{ending}"
    command = [*before, program, library(libraries, fmi, name), fmi, identity]
    command += [references[n] for n in ("stride.count", "stride.word", *COMPARED)]
    lines = [line.split() for line in succeed(*command, env=environment).splitlines()]
    assert [line[0] for line in lines] == ["CoSimulation", "ModelExchange"]
    return {line[0]: (line[1], [float(value) for value in line[2:]]) for line in lines}


@pytest.fixture(scope="module")
def linux(libraries):
    names = {2: "linux64/TDMF_SLIP.so", 3: "x86_64-linux/TDMF_SLIP.so"}
    return {fmi: seen(libraries, fmi, name, "x86_64-linux") for fmi, name in names.items()}


def assert_same(there, here):
    for interface, (word, values) in here.items():
        assert there[interface][0] == word
        assert there[interface][1] == pytest.approx(values, rel=1e-12), interface


@pytest.mark.parametrize("fmi", UNITS)
def test_linux_has_the_reference_strides(linux, fmi):
    for interface, tolerance in {"CoSimulation": 1e-8, "ModelExchange": 1e-6}.items():
        word, values = linux[fmi][interface]
        assert word == REFERENCE["word"]
        for name, value in zip(QUANTITIES, values, strict=False):
            assert value == pytest.approx(REFERENCE[name], rel=tolerance), (interface, name)


@pytest.mark.skipif(windows() is None, reason="NOT TESTED: Windows, wine64 is not installed")
@pytest.mark.parametrize(("fmi", "name"), [(2, "win64/TDMF_SLIP.dll"), (3, "x86_64-windows/TDMF_SLIP.dll")])
def test_windows_sees_what_linux_sees(libraries, linux, fmi, name):
    emulator, environment = windows()
    there = seen(libraries, fmi, name, "x86_64-windows", emulator, ".exe", environment)
    assert_same(there, linux[fmi])


@pytest.mark.skipif(
    arm_linux() is None,
    reason="NOT TESTED: Arm Linux, qemu-user or libc6-arm64-cross is not installed",
)
def test_arm_linux_sees_what_linux_sees(libraries, linux):
    emulator, environment = arm_linux()
    there = seen(libraries, 3, "aarch64-linux/TDMF_SLIP.so", "aarch64-linux", emulator, "", environment)
    assert_same(there, linux[3])


def test_a_page_of_one_s_own_is_built_for_other_platforms_beside_this_one(tmp_path):
    folder = tdmf_slip.new(tmp_path / "my_ball", start="scratch")
    for platform in (None, "aarch64-linux", "x86_64-windows"):
        built = tdmf_slip.build(folder, platform=platform)
    table = json.loads((built / TABLE).read_text(encoding="utf-8"))
    platforms = {host(), "aarch64-linux", "x86_64-windows"}
    assert set(table["libraries"]) == platforms
    assert all((built / name).is_file() for name in table["libraries"].values())
    found = {}
    for unit in ("MyBall.fmu", "MyBall_FMI3.fmu"):
        assert validate_fmu(str(built / unit)) == []
        with zipfile.ZipFile(built / unit) as packed:
            found[unit] = {n.split("/")[1] for n in packed.namelist() if n.startswith("binaries/")}
            assert all(n.endswith((".so", ".dll", ".dylib")) for n in packed.namelist() if "binaries/" in n)
    assert found["MyBall_FMI3.fmu"] == platforms and {"linux64", "win64"} <= found["MyBall.fmu"] | {"linux64"}
    model = tdmf_slip.load_model(folder)
    assert fmpy.simulate_fmu(str(model.unit), stop_time=0.2)["height"][-1] < 1
