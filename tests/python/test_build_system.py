"""Builds in odd places and with odd settings, mostly without compiling: what CMake makes of the project."""

import itertools
import json
import os
import pathlib
import shlex
import shutil
import sys
import zipfile

import pytest
from conftest import ROOT, succeed

HEADERS = ROOT / "c_core" / "include"
COMPILES_NOTHING = """\
#!/bin/sh
while [ $# -gt 0 ]; do [ "$1" = -o ] && { : > "$2"; exit; }; shift; done
"""
"""Stands in front of compiler and linker, and writes empty files in their place."""


@pytest.fixture(scope="module")
def launcher(tmp_path_factory):
    path = tmp_path_factory.mktemp("launcher") / "launcher"
    path.write_text(COMPILES_NOTHING)
    path.chmod(0o755)
    return path


def configure(source, build, launcher, **settings):
    """CMake's first step, with nothing to be compiled in the build; its file API tells of the targets."""
    query = build / ".cmake" / "api" / "v1" / "query"
    query.mkdir(parents=True)
    (query / "codemodel-v2").touch()
    settings |= {
        "Python3_EXECUTABLE": sys.executable,
        "CMAKE_C_COMPILER_LAUNCHER": launcher,
        "CMAKE_C_LINKER_LAUNCHER": launcher,
    }
    succeed("cmake", "-S", source, "-B", build, *(f"-D{name}={value}" for name, value in settings.items()))


def replies(build, kind):
    return [
        json.loads(path.read_text(encoding="utf-8"))
        for path in (build / ".cmake" / "api" / "v1" / "reply").glob(f"{kind}-*.json")
    ]


def test_units_are_built_in_a_folder_of_any_name(tmp_path, launcher):
    """All letters that CMake itself copes with; what is made once is made again over it."""
    folder = tmp_path / "Prüfung 試 [a] + (b) & @c@ $d {e} it's 50% *?"
    folder.mkdir()
    (folder / "source").symlink_to(ROOT)
    configure(folder / "source", folder / "build", launcher)
    for _ in range(2):
        succeed("cmake", folder / "build")
        succeed(
            "cmake", "--build", folder / "build", "--target", "tdmf_slip_fmi2_unit", "tdmf_slip_fmi3_unit"
        )
        os.utime(folder / "build" / "fmu_src" / "generated" / "fmi2" / "files.txt")
    for file in ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu"):
        with zipfile.ZipFile(folder / "build" / "fmu_src" / file) as unit:
            names = set(unit.namelist())
        assert {"modelDescription.xml", "sources/unit_page.c", "sources/page_exchange.h"} <= names
        assert any(name.startswith("binaries/") and "TDMF_SLIP." in name for name in names)


@pytest.fixture(scope="module")
def inside(tmp_path_factory, launcher):
    """The build of a project that has this one as a part."""
    folder = tmp_path_factory.mktemp("part")
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.21)\nproject(host LANGUAGES C)\n"
        f'add_subdirectory("{ROOT}" runner)\nadd_executable(host host.c)\n'
        "target_link_libraries(host PRIVATE tdmf_slip::tdmf_slip)\n"
    )
    (folder / "host.c").write_text("int main(void) { return 0; }\n")
    configure(folder, folder / "build", launcher)
    return folder / "build"


def test_as_a_part_of_another_project_all_names_are_its_own(inside):
    targets = {reply["name"] for reply in replies(inside, "target")}
    assert "tdmf_slip_ensemble" in targets
    assert {name for name in targets if not name.startswith("tdmf_slip")} == {"host"}
    cache = (inside / "CMakeCache.txt").read_text(encoding="utf-8").splitlines()
    entries = {line.split(":")[0] for line in cache if ":" in line and not line.startswith(("#", "//"))}
    known = ("CMAKE_", "TDMF_SLIP_", "tdmf_slip_", "host_", "CVODE_", "FIND_PACKAGE_", "Python3_", "_")
    assert [name for name in entries if not name.strip('"').startswith(known)] == []


def test_as_a_part_of_another_project_it_builds_and_installs_nothing_unasked(inside):
    assert not any(reply["installers"] for reply in replies(inside, "directory"))
    assert not [reply["name"] for reply in replies(inside, "target") if "unit" in reply["name"]]


@pytest.mark.skipif(shutil.which("pkg-config") is None, reason="pkg-config is not installed")
@pytest.mark.parametrize("library_folder", ["lib", "lib/sub", "/opt/else where/lib"])
@pytest.mark.parametrize("header_folder", ["include", "/opt/the headers"])
def test_pkg_config_finds_absolute_folders(tmp_path_factory, configured, library_folder, header_folder):
    """Relative folders move with the file, absolute ones stay; spaces are quoted."""
    moved = tmp_path_factory.mktemp("moved to")
    succeed(
        "cmake",
        f"-DCMAKE_INSTALL_LIBDIR={library_folder}",
        f"-DCMAKE_INSTALL_INCLUDEDIR={header_folder}",
        configured,
    )
    packages = moved / library_folder.lstrip("/") / "pkgconfig"
    packages.mkdir(parents=True)
    shutil.copy(configured / "c_core" / "tdmf_slip.pc", packages)
    environment = os.environ | {"PKG_CONFIG_PATH": str(packages)}
    flags = shlex.split(succeed("pkg-config", "--cflags", "--libs", "tdmf_slip", env=environment))
    found = {flag[:2]: pathlib.Path(os.path.normpath(flag[2:])) for flag in flags if flag[:2] in ("-I", "-L")}
    prefix = pathlib.Path("/usr/local") if library_folder.startswith("/") else moved
    assert found == {"-I": prefix / header_folder, "-L": moved / library_folder}


@pytest.fixture(scope="module")
def configured(tmp_path_factory, launcher):
    build = tmp_path_factory.mktemp("configured")
    configure(ROOT, build, launcher, TDMF_SLIP_BUILD_FMU="OFF", CMAKE_UNITY_BUILD="ON")
    return build


def test_files_are_compiled_alone_though_a_unity_build_is_asked_for(configured):
    sources = [source["path"] for reply in replies(configured, "target") for source in reply["sources"]]
    assert any(path.endswith("page_solver.c") for path in sources)
    assert not [path for path in sources if "unity" in path]


@pytest.mark.parametrize(
    ("compiler", "standard"),
    [
        *itertools.product(["g++", "clang++"], ["c++98", "c++11", "c++20", "c++2b"]),
        *itertools.product(["gcc", "clang"], ["c99", "c17", "c2x"]),
    ],
)
def test_headers_are_valid_in_every_standard(tmp_path, compiler, standard):
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    program = tmp_path / ("headers.cpp" if "++" in standard else "headers.c")
    names = sorted(str(path.relative_to(HEADERS)) for path in HEADERS.rglob("*.h"))
    program.write_text("".join(f'#include "{name}"\n' for name in names))
    succeed(
        compiler,
        f"-std={standard}",
        "-fsyntax-only",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Werror",
        f"-I{HEADERS}",
        program,
    )
