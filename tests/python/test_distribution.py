"""What is given out (dist, made by ./scripts/release): wheel and source distribution, installed and run."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import pytest
from test_platforms import ARM_LIBRARIES, QEMU, WINE

lief = pytest.importorskip("lief", reason="NOT TESTED: the distribution, lief is not installed")

ROOT = pathlib.Path(__file__).resolve().parents[2]
WHEELS = {re.sub(r".*-py3-none-(.*)\.whl", r"\1", path.name): path for path in (ROOT / "dist").glob("*.whl")}
"""By platform tag."""
HERE = "manylinux_2_17_x86_64"
SYSTEMS = {
    HERE: (lief.ELF, "linux_x86_64", "libtdmf_slip_shared.so"),
    "manylinux_2_17_aarch64": (lief.ELF, "linux_aarch64", "libtdmf_slip_shared.so"),
    "win_amd64": (lief.PE, "AMD64", "tdmf_slip_shared.dll"),
    "win_arm64": (lief.PE, "ARM64", "tdmf_slip_shared.dll"),
    "macosx_11_0_x86_64": (lief.MachO, "X86_64", "libtdmf_slip_shared.dylib"),
    "macosx_11_0_arm64": (lief.MachO, "ARM64", "libtdmf_slip_shared.dylib"),
}
"""By platform tag: format, processor, and the library's file in the wheel."""
SOURCES = list((ROOT / "dist").glob("*.tar.gz"))
UNITS = ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu")

pytestmark = pytest.mark.skipif(
    not (HERE in WHEELS and SOURCES),
    reason="NOT TESTED: wheel and source distribution; ./scripts/release makes them",
)


def run(*command, **options):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=600, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def assert_runs(environment, variables):
    (package,) = environment.folder.glob("lib/*/site-packages/tdmf_slip")
    assert all((package / unit).is_file() for unit in UNITS)
    command = environment.programs / "tdmf-slip"
    run_by_unit = json.loads(run(command, "simulate", "--strides", "2", "--json", env=variables))
    gait_by_library = json.loads(run(command, "gait", "--friction", "0.6", "--json", env=variables))
    for stride, tolerance in ((run_by_unit["stride"], 1e-6), (gait_by_library, 1e-9)):
        assert stride["word"] == "+0-0+"
        assert stride["period"] == pytest.approx(24.76444922801218, rel=tolerance)


def test_the_wheel_installs_and_runs_without_a_compiler(environment):
    variables = environment.install(WHEELS[HERE])
    for compiler in ("cc", "gcc", "clang", "cmake", "ninja"):
        assert shutil.which(compiler, path=variables["PATH"]) is None
    assert_runs(environment, variables)


def test_the_source_distribution_installs_and_runs(environment):
    """By the compiler of the machine; CVODE comes along where SUNDIALS is found."""
    assert_runs(environment, environment.install(SOURCES[0], path=os.environ["PATH"]))


def elf_files(wheel):
    """Every ELF file of a wheel, in the units too."""
    with zipfile.ZipFile(wheel) as outer:
        for name in outer.namelist():
            if name.endswith(".fmu"):
                with outer.open(name) as file, zipfile.ZipFile(file) as unit:
                    yield from (unit.read(n) for n in unit.namelist() if n.endswith(".so"))
            elif name.endswith(".so"):
                yield outer.read(name)


def test_the_wheels_tag_is_true():
    """No binary in it needs a newer glibc than the tag promises; any Python 3 will do."""
    wheel = WHEELS[HERE]
    promised = re.search(r"-py3-none-manylinux_(\d+)_(\d+)_x86_64\.whl$", wheel.name)
    assert promised, wheel.name
    files = [lief.ELF.parse(list(data)) for data in elf_files(wheel)]
    assert len(files) >= 4
    for file in files:
        needed = [
            tuple(map(int, version.name.removeprefix("GLIBC_").split(".")))
            for requirement in file.symbols_version_requirement
            for version in requirement.get_auxiliary_symbols()
        ]
        assert max(needed) <= tuple(map(int, promised.groups()))


def test_the_source_distribution_is_what_git_has():
    """Nothing of a build in it, and nothing of the sources forgotten."""
    with tarfile.open(SOURCES[0]) as archive:
        names = {name.split("/", 1)[1] for name in archive.getnames() if "/" in name}
    tracked = set(run("git", "ls-files", cwd=ROOT).splitlines())
    assert {
        name for name in tracked if name.split("/")[0] in ("c_core", "fmu_src", "cmake", "scripts")
    } <= names
    assert not [name for name in names if name.startswith(("build/", "dist/", "results/", ".venv/"))]


def unpacked_library(tag, folder):
    """The library of a wheel, beside its headers."""
    with zipfile.ZipFile(WHEELS[tag]) as wheel:
        native = [name for name in wheel.namelist() if name.startswith("tdmf_slip/native/")]
        wheel.extractall(folder, native)
    return folder / "tdmf_slip/native" / SYSTEMS[tag][2]


def processor_of(file):
    """As the file's own header says."""
    if isinstance(file, lief.ELF.Binary):
        return {"X86_64": "linux_x86_64", "AARCH64": "linux_aarch64"}[file.header.machine_type.name]
    return file.header.machine.name if isinstance(file, lief.PE.Binary) else file.header.cpu_type.name


def test_there_is_a_wheel_for_every_platform_that_the_units_have(tmp_path):
    """With the library that the Python package looks for there, compiled for that processor."""
    assert set(WHEELS) == set(SYSTEMS)
    for tag, (form, processor, _) in SYSTEMS.items():
        library = unpacked_library(tag, tmp_path / tag)
        file = lief.parse(str(library))
        assert type(file).__module__ == form.__name__ and processor_of(file) == processor, tag


@pytest.mark.parametrize(
    ("tag", "target", "emulator"),
    [
        ("win_amd64", "x86_64-windows-gnu", WINE and [WINE]),
        ("manylinux_2_17_aarch64", "aarch64-linux-gnu.2.17", QEMU and [QEMU, "-L", str(ARM_LIBRARIES)]),
    ],
)
def test_the_library_of_a_wheel_runs_on_its_platform(tag, target, emulator, tmp_path):
    """A program that was compiled against it finds the gait of the paper."""
    if not emulator:
        pytest.skip(f"NOT TESTED: the library of {tag}, because there is no emulator")
    library = unpacked_library(tag, tmp_path)
    program = library.parent / "strides.exe"
    compiler = (sys.executable, "-m", "ziglang", "cc", "-target", target, "-std=c99", f"-I{library.parent}")
    source = ROOT / "tests/consumer/strides.c"
    run(*compiler, source, library, "-Wl,-rpath,$ORIGIN" if library.suffix == ".so" else "-s", "-o", program)
    variables = os.environ | {"WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all"}
    said = run(*emulator, program, env=variables, cwd=library.parent)
    assert said.split() == ["+0-,", "speed", "1.033110,", "cost", "of", "transport", "0.364532"]
