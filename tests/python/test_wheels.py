"""The wheels of all platforms (dist, made by ./scripts/release): what is in them, and whether it runs there.

Windows runs under wine, Arm Linux under qemu, by small programs in C; what is for macOS and Arm Windows is
read.
"""

import platform
import re
import sys
import zipfile

import pytest
from conftest import ROOT, succeed
from emulators import arm_linux, windows
from tdmf_slip.library.binding import c
from test_distribution import assert_runs
from test_installed_library import CONSUMER, SAYS

lief = pytest.importorskip("lief", reason="NOT TESTED: wheels, lief is not installed")
wheelfile = pytest.importorskip("wheel.wheelfile", reason="NOT TESTED: wheels, wheel is not installed")
metadata = pytest.importorskip("packaging.metadata")
utils = pytest.importorskip("packaging.utils")

WHEELS = {path.stem.rpartition("-")[2]: path for path in (ROOT / "dist").glob("*.whl")}
"""The keys are platform tags."""
UNITS = {name: f"tdmf_slip/{name}" for name in ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu")}
ELF, PE, MACH = "ELF", "PE", "MachO"
PLATFORMS = {
    "manylinux_2_17_x86_64": (ELF, "X86_64", "libtdmf_slip_shared.so"),
    "manylinux_2_17_aarch64": (ELF, "AARCH64", "libtdmf_slip_shared.so"),
    "win_amd64": (PE, "AMD64", "tdmf_slip_shared.dll"),
    "win_arm64": (PE, "ARM64", "tdmf_slip_shared.dll"),
    "macosx_11_0_x86_64": (MACH, "X86_64", "libtdmf_slip_shared.dylib"),
    "macosx_11_0_arm64": (MACH, "ARM64", "libtdmf_slip_shared.dylib"),
}
"""By platform tag: format, processor, and the library's file as the Python package asks for it there."""
EMULATORS = {
    "win_amd64": (windows(), "x86_64-windows-gnu"),
    "manylinux_2_17_aarch64": (arm_linux(), "aarch64-linux-gnu.2.17"),
}
"""By platform tag: how a program of it is run here, and what Zig calls the platform."""
TOOLCHAIN = (ROOT / "cmake" / "zig.cmake").read_text(encoding="utf-8")
FLAGS = re.search(r'C_FLAGS_INIT "-target \$\{TDMF_SLIP_TARGET\} ([^"]+)"', TOOLCHAIN)[1].split()
"""Those of the wheels: Zig compiles the C runtime anew for others, which takes minutes for Windows.

It also does so where it is called in a folder that it lies in, such as ROOT: it names its own files relative
to that.
"""

pytestmark = pytest.mark.skipif(not WHEELS, reason="NOT TESTED: wheels; ./scripts/release makes them")
each_platform = pytest.mark.parametrize("tag", PLATFORMS)


@pytest.fixture
def library_of():
    """Reads the library of a platform's wheel."""
    whole = []  # a Mach-O file owns its parts

    def read(tag):
        form, _, name = PLATFORMS[tag]
        with zipfile.ZipFile(WHEELS[tag]) as wheel:
            data = wheel.read(f"tdmf_slip/native/{name}")
        whole.append({ELF: lief.ELF, PE: lief.PE, MACH: lief.MachO}[form].parse(list(data)))
        return next(iter(whole[-1])) if form == MACH else whole[-1]

    return read


def test_there_is_a_wheel_for_every_platform_that_the_units_have():
    assert set(WHEELS) == set(PLATFORMS)


@each_platform
def test_a_wheel_is_what_its_name_says(tag):
    """By the libraries that installers use: tags, checksums, metadata. Both units are whole."""
    path = WHEELS[tag]
    name, version, _, tags = utils.parse_wheel_filename(path.name)
    assert {str(found) for found in tags} == {f"py3-none-{tag}"}
    with wheelfile.WheelFile(path) as wheel:
        listed = set(wheel.namelist())
        for member in listed:
            wheel.read(member)  # which compares it with RECORD
        about = f"{wheel.parsed_filename['namever']}.dist-info"
        said = wheel.read(f"{about}/WHEEL").decode().splitlines()
        assert f"Tag: py3-none-{tag}" in said and "Root-Is-Purelib: false" in said
        found = metadata.Metadata.from_email(wheel.read(f"{about}/METADATA"), validate=True)
        assert (found.name, str(found.version)) == (name, str(version))
        assert "dist-info/licenses/LICENSE" in " ".join(listed)
        for unit, member in UNITS.items():
            assert wheel.read(member) == (ROOT / "dist" / unit).read_bytes()
    libraries = {member for member in listed if member.endswith((".so", ".dll", ".dylib", ".lib", ".a"))}
    assert libraries == {f"tdmf_slip/native/{PLATFORMS[tag][2]}"}


@each_platform
def test_nothing_in_a_wheel_names_the_folder_that_it_was_built_in(tag):
    """Else two people who build the same sources get different bytes, and a stranger's folder is on show."""
    folder = str(ROOT).encode()
    with zipfile.ZipFile(WHEELS[tag]) as wheel:
        contents = {member: wheel.read(member) for member in wheel.namelist()}
    assert len(contents) > 100
    assert [member for member, content in contents.items() if folder in content] == []


@each_platform
def test_a_wheels_library_is_for_its_processor_and_exports_what_the_headers_declare(tag, library_of):
    form, processor, _ = PLATFORMS[tag]
    file = library_of(tag)
    if form == PE:
        machine, names = file.header.machine, {entry.name for entry in file.get_export().entries}
    elif form == MACH:
        machine = file.header.cpu_type
        of_the_linker = {"___dso_handle", "__mh_dylib_header"}
        exports = {export.symbol.name for export in file.dyld_info.exports} - of_the_linker
        names = {name.removeprefix("_") for name in exports}
    else:
        machine, names = file.header.machine_type, {symbol.name for symbol in file.exported_symbols}
    assert machine.name == processor
    wanted = {name for name in dir(c) if name.startswith("tdmf_")}
    assert len(wanted) > 45 and names == wanted


def elf_files(wheel):
    """Every ELF file of a wheel, in the units too."""
    with zipfile.ZipFile(wheel) as outer:
        for name in outer.namelist():
            if name.endswith(".fmu"):
                with outer.open(name) as file, zipfile.ZipFile(file) as unit:
                    yield from (unit.read(n) for n in unit.namelist() if n.endswith(".so"))
            elif name.endswith(".so"):
                yield outer.read(name)


@pytest.mark.parametrize("tag", [tag for tag in PLATFORMS if tag.startswith("manylinux")])
def test_a_wheel_for_linux_needs_no_newer_glibc_than_its_tag_promises(tag):
    promised = tuple(map(int, re.fullmatch(r"manylinux_(\d+)_(\d+)_.*", tag).groups()))
    files = [lief.ELF.parse(list(data)) for data in elf_files(WHEELS[tag])]
    assert len(files) >= 4
    for file in files:
        needed = [
            tuple(map(int, version.name.removeprefix("GLIBC_").split(".")))
            for requirement in file.symbols_version_requirement
            for version in requirement.get_auxiliary_symbols()
        ]
        assert max(needed) <= promised


def test_the_wheel_for_this_linux_installs_and_runs(environment):
    assert_runs(environment, environment.install(WHEELS[f"manylinux_2_17_{platform.machine()}"]))


@pytest.mark.parametrize("tag", [tag for tag in PLATFORMS if tag.startswith("macosx")])
def test_a_wheel_for_macos_asks_for_the_system_of_its_tag_and_for_no_other_library(tag, library_of):
    """And for Apple's Arm processors, which run nothing else, it is signed."""
    file = library_of(tag)
    promised = list(map(int, re.fullmatch(r"macosx_(\d+)_(\d+)_.*", tag).groups()))
    assert list(file.build_version.minos)[:2] == promised
    own = lief.MachO.LoadCommand.TYPE.ID_DYLIB
    assert [used.name for used in file.libraries if used.command == own] == [f"@rpath/{PLATFORMS[tag][2]}"]
    assert {used.name for used in file.libraries if used.command != own} == {"/usr/lib/libSystem.B.dylib"}
    assert file.has_code_signature or not tag.endswith("arm64")


@pytest.mark.parametrize("tag", [tag for tag in PLATFORMS if tag.startswith("win")])
def test_a_wheel_for_windows_asks_for_no_library_that_windows_10_does_not_have(tag, library_of):
    names = {used.name.lower() for used in library_of(tag).imports}
    assert names
    assert {name for name in names if not name.startswith("api-ms-win-crt-")} <= {"kernel32.dll", "ntdll.dll"}


@pytest.mark.parametrize("tag", EMULATORS)
def test_the_library_of_a_wheel_runs_on_its_platform(tag, tmp_path):
    """Programs compiled against it as it lies there: one runner, and many with their threads."""
    emulator, target = EMULATORS[tag]
    if emulator is None:
        pytest.skip(f"NOT TESTED: the library of {tag}, because there is no emulator")
    command, variables = emulator
    with zipfile.ZipFile(WHEELS[tag]) as wheel:
        wheel.extractall(tmp_path, [n for n in wheel.namelist() if n.startswith("tdmf_slip/native/")])
    native = tmp_path / "tdmf_slip/native"
    compiler = (sys.executable, "-m", "ziglang", "cc", "-target", target, "-std=c99", *FLAGS, f"-I{native}")
    for program in ("strides", "population"):
        built = native / f"{program}.exe"
        links = [native / PLATFORMS[tag][2]] + (["-Wl,-rpath,$ORIGIN"] if "linux" in tag else [])
        succeed(*compiler, CONSUMER / f"{program}.c", *links, "-o", built, cwd=native)
        assert succeed(*command, built, env=variables, cwd=native).startswith(SAYS[program])
