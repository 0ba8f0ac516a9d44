"""The units with every platform's binaries (build/platforms, made by ./scripts/release).

Windows runs under wine, Arm Linux under qemu, by a small importer in C (tests/platforms), and has to see what
Linux sees; the files for macOS and Arm Windows are read.
"""

import json
import pathlib
import re
import subprocess
import zipfile

import fmpy
import pytest
import tdmf_slip
from conftest import HANGS, QUANTITIES, ROOT, unit_reference
from emulators import arm_linux, windows
from fmpy.validation import validate_fmu
from tdmf_slip.builds import TABLE, host

lief = pytest.importorskip("lief", reason="NOT TESTED: units for every platform, lief is not installed")

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
ALL = [(fmi, name) for fmi in BINARIES for name in BINARIES[fmi]]
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


def functions(fmi):
    """All that the standard has, from its header."""
    header = (HEADERS / f"fmi{fmi}Functions.h").read_text(encoding="utf-8")
    return set(re.findall(rf"FMI{fmi}_Export +\w+TYPE +(fmi{fmi}\w+);", header))


def library(libraries, fmi, name):
    return libraries[fmi] / "binaries" / name


@pytest.mark.parametrize("fmi", UNITS)
def test_every_platform_is_there_and_nothing_else(fmi):
    with zipfile.ZipFile(UNITS[fmi]) as unit:
        names = [n.removeprefix("binaries/") for n in unit.namelist() if n.startswith("binaries/")]
        assert "sources/native_runs.c" in unit.namelist()
    assert sorted(names) == sorted(BINARIES[fmi])
    assert validate_fmu(str(UNITS[fmi])) == []


@pytest.mark.parametrize(("fmi", "name"), [case for case in ALL if case[1].endswith(".so")])
def test_linux_needs_libc_and_libm_of_2012(libraries, fmi, name):
    elf = lief.ELF.parse(str(library(libraries, fmi, name)))
    processor = {
        "x86_64": lief.ELF.ARCH.X86_64,
        "linux64": lief.ELF.ARCH.X86_64,
        "aarch64": lief.ELF.ARCH.AARCH64,
    }
    assert elf.header.machine_type == processor[name.split("-")[0].split("/")[0]]
    # On Arm the stack protector's guard is in the loader, which is the C library's own.
    assert set(elf.libraries) <= {"libc.so.6", "libm.so.6", "ld-linux-aarch64.so.1"}
    versions = [
        tuple(map(int, version.name.removeprefix("GLIBC_").split(".")))
        for requirement in elf.symbols_version_requirement
        for version in requirement.get_auxiliary_symbols()
    ]
    assert versions and max(versions) <= (2, 17)
    assert {symbol.name for symbol in elf.exported_symbols} == functions(fmi)


@pytest.mark.parametrize(("fmi", "name"), [case for case in ALL if case[1].endswith(".dylib")])
def test_macos_files(libraries, fmi, name):
    """Universal in FMI 2.0; signed (Apple's Arm processors run nothing else); only the system's library."""
    whole = lief.MachO.parse(str(library(libraries, fmi, name)))  # owns its parts
    files = list(whole)
    cpu = lief.MachO.Header.CPU_TYPE
    wanted = {
        "darwin64": {cpu.X86_64, cpu.ARM64},
        "x86_64-darwin": {cpu.X86_64},
        "aarch64-darwin": {cpu.ARM64},
    }
    assert {file.header.cpu_type for file in files} == wanted[name.split("/")[0]]
    for file in files:
        others = [
            used.name for used in file.libraries if used.command != lief.MachO.LoadCommand.TYPE.ID_DYLIB
        ]
        assert others == ["/usr/lib/libSystem.B.dylib"]
        if file.header.cpu_type == cpu.ARM64:
            assert file.has_code_signature
        assert file.build_version.minos <= [11, 0, 0]
        of_the_linker = {"___dso_handle", "__mh_dylib_header"}
        exports = {export.symbol.name for export in file.dyld_info.exports} - of_the_linker
        assert exports == {f"_{name}" for name in functions(fmi)}


@pytest.mark.parametrize(("fmi", "name"), [case for case in ALL if case[1].endswith(".dll")])
def test_windows_files(libraries, fmi, name):
    """No library that Windows 10 does not have."""
    pe = lief.PE.parse(str(library(libraries, fmi, name)))
    machine = lief.PE.Header.MACHINE_TYPES
    assert pe.header.machine == (machine.ARM64 if name.startswith("aarch64") else machine.AMD64)
    for used in pe.imports:
        assert used.name.lower() == "kernel32.dll" or used.name.lower().startswith("api-ms-win-crt-"), (
            used.name
        )
    assert {entry.name for entry in pe.get_export().entries} == functions(fmi)


# ---- running ------------------------------------------------------------------------------------------


def seen(libraries, fmi, name, build, before=(), ending="", environment=None):
    """What the importer of a platform sees: {interface: (word, values)}."""
    description = fmpy.read_model_description(str(UNITS[fmi]))
    references = {v.name: str(v.valueReference) for v in description.modelVariables}
    identity = description.guid if fmi == 2 else description.instantiationToken
    program = PLATFORMS / build / "tests/platforms" / f"importer{ending}"
    command = [*before, program, library(libraries, fmi, name), fmi, identity]
    command += [references[n] for n in ("stride.count", "stride.word", *COMPARED)]
    done = subprocess.run(
        list(map(str, command)), capture_output=True, text=True, env=environment, timeout=HANGS
    )
    assert done.returncode == 0, done.stdout + done.stderr
    lines = [line.split() for line in done.stdout.splitlines()]
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
