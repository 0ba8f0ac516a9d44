"""The wheels of all platforms (dist, made by ./scripts/release): what is in them, and whether it runs there.

Windows runs under wine, Arm Linux under qemu, by small programs in C; what is for macOS and Arm Windows is
read.
"""

import platform
import re
import sys
import zipfile

import pytest
from binaries import Library, arm_linux, libraries_in, windows
from conftest import ROOT, succeed
from tdmf_slip.library.binding import c
from test_distribution import assert_runs
from test_installed_library import CONSUMER, SAYS

wheelfile = pytest.importorskip("wheel.wheelfile", reason="NOT TESTED: wheels, wheel is not installed")
metadata = pytest.importorskip("packaging.metadata")
utils = pytest.importorskip("packaging.utils")

WHEELS = {path.stem.rpartition("-")[2]: path for path in (ROOT / "dist").glob("*.whl")}
"""The keys are platform tags."""
UNITS = {name: f"tdmf_slip/{name}" for name in ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu")}
PLATFORMS = {
    "manylinux_2_17_x86_64": ("x86_64", "libtdmf_slip_shared.so"),
    "manylinux_2_17_aarch64": ("aarch64", "libtdmf_slip_shared.so"),
    "win_amd64": ("x86_64", "tdmf_slip_shared.dll"),
    "win_arm64": ("aarch64", "tdmf_slip_shared.dll"),
    "macosx_11_0_x86_64": ("x86_64", "libtdmf_slip_shared.dylib"),
    "macosx_11_0_arm64": ("aarch64", "libtdmf_slip_shared.dylib"),
}
"""Processor, and the library's file name that the Python package loads, by platform tag."""
EMULATORS = {
    "win_amd64": (windows(), "x86_64-windows-gnu"),
    "manylinux_2_17_aarch64": (arm_linux(), "aarch64-linux-gnu.2.17"),
}
"""Emulator of a platform, and Zig's name for the platform, by platform tag."""
TOOLCHAIN = (ROOT / "cmake" / "zig.cmake").read_text(encoding="utf-8")
FLAGS = re.search(r'C_FLAGS_INIT "-target \$\{TDMF_SLIP_TARGET\} ([^"]+)"', TOOLCHAIN)[1].split()
"""Flags of the wheels. Zig compiles the C runtime anew for others, which takes minutes for Windows.

It also does so where it is called in a folder that it lies in, such as ROOT: it names its own files relative
to that.
"""

pytestmark = pytest.mark.skipif(not WHEELS, reason="NOT TESTED: wheels; ./scripts/release makes them")
each_platform = pytest.mark.parametrize("tag", PLATFORMS)


def test_there_is_a_wheel_for_every_platform_that_the_units_have():
    assert set(WHEELS) == set(PLATFORMS)


@each_platform
def test_a_wheel_is_what_its_name_says(tag):
    """Installers' own libraries read tags, checksums and metadata. Both units are whole."""
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
    assert libraries == {f"tdmf_slip/native/{PLATFORMS[tag][1]}"}


@each_platform
def test_nothing_in_a_wheel_names_the_folder_that_it_was_built_in(tag):
    """The folder's name would change the bytes from one builder to the next, and show a stranger's folder."""
    folder = str(ROOT).encode()
    with zipfile.ZipFile(WHEELS[tag]) as wheel:
        contents = {member: wheel.read(member) for member in wheel.namelist()}
    assert len(contents) > 100
    assert [member for member, content in contents.items() if folder in content] == []


@each_platform
def test_a_wheels_library_is_for_its_processor_and_exports_what_the_headers_declare(tag):
    """All libraries of a wheel, those of its units too, load nothing that the platform of the tag lacks."""
    processor, name = PLATFORMS[tag]
    found = {path: Library(data) for path, data in libraries_in(WHEELS[tag])}
    own = found[f"tdmf_slip/native/{name}"]
    wanted = {name for name in dir(c) if name.startswith("tdmf_")}
    assert own.processors == {processor} and len(wanted) > 45 and own.exports == wanted
    assert not own.is_macos or own.own_name == f"@rpath/{name}"
    assert len(found) > 1
    for library in found.values():
        library.assert_needs_only_the_system()


def test_the_wheel_for_this_linux_installs_and_runs(environment):
    assert_runs(environment, environment.install(WHEELS[f"manylinux_2_17_{platform.machine()}"]))


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
        links = [native / PLATFORMS[tag][1]] + (["-Wl,-rpath,$ORIGIN"] if "linux" in tag else [])
        succeed(*compiler, CONSUMER / f"{program}.c", *links, "-o", built, cwd=native)
        assert succeed(*command, built, env=variables, cwd=native).startswith(SAYS[program])
