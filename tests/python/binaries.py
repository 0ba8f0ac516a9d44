"""Libraries of every platform: what their files say of themselves; emulators that run some of them here."""

import os
import pathlib
import re
import shutil
import zipfile

import pytest
from conftest import ROOT

lief = pytest.importorskip("lief", reason="NOT TESTED: binaries of platforms, lief is not installed")

SUFFIXES = (".so", ".dll", ".dylib")
SYSTEM = {"/usr/lib/libSystem.B.dylib"}, {"kernel32.dll", "ntdll.dll"}
"""Libraries that macOS, and that Windows 10 has, beside those of the C runtime."""
OLDEST_MACOS = [11, 0]


class Library:
    """A library file: one for a processor, or the several of a universal file."""

    def __init__(self, data):
        data = list(data)
        self.parsed = lief.parse(data)  # a Mach-O file owns its parts
        form = type(self.parsed)
        self.is_elf, self.is_windows = form is lief.ELF.Binary, form is lief.PE.Binary
        self.is_macos = not (self.is_elf or self.is_windows)
        self.universal = lief.MachO.parse(data) if self.is_macos else None
        self.parts = list(self.universal) if self.is_macos else [self.parsed]

    @property
    def processors(self):
        """Names of the processors, `x86_64` or `aarch64`."""
        found = {
            part.header.machine_type if self.is_elf else
            part.header.machine if self.is_windows else part.header.cpu_type
            for part in self.parts
        }  # fmt: skip
        names = {"X86_64": "x86_64", "AMD64": "x86_64", "AARCH64": "aarch64", "ARM64": "aarch64"}
        return {names[processor.name] for processor in found}

    @property
    def exports(self):
        """Names that the library exports; all parts of a universal file export the same."""
        if self.is_windows:
            return {entry.name for entry in self.parsed.get_export().entries}
        if self.is_elf:
            return {symbol.name for symbol in self.parsed.exported_symbols}
        of_the_linker = {"___dso_handle", "__mh_dylib_header"}
        first, *others = (
            {export.symbol.name for export in part.dyld_info.exports} - of_the_linker for part in self.parts
        )
        assert all(other == first for other in others)
        return {name.removeprefix("_") for name in first}

    @property
    def own_name(self):
        """The name by which other programs of macOS load the library."""
        own = lief.MachO.LoadCommand.TYPE.ID_DYLIB
        (name,) = {used.name for part in self.parts for used in part.libraries if used.command == own}
        return name

    def assert_needs_only_the_system(self):
        """Check that a Linux of 2012, macOS 11 and Windows 10 have all that the library loads.

        Apple's Arm processors run only what is signed.
        """
        if self.is_windows:
            names = {used.name.lower() for used in self.parsed.imports}
            assert names and {n for n in names if not n.startswith("api-ms-win-crt-")} <= SYSTEM[1]
        elif self.is_elf:
            # The loader is part of the C library; on Arm it holds the stack protector's guard.
            known = {"libc.so.6", "libm.so.6", "libpthread.so.0", "ld-linux-aarch64.so.1"}
            assert set(self.parsed.libraries) <= known
            versions = [
                tuple(map(int, version.name.removeprefix("GLIBC_").split(".")))
                for requirement in self.parsed.symbols_version_requirement
                for version in requirement.get_auxiliary_symbols()
            ]
            assert versions and max(versions) <= (2, 17)
        else:
            for part in self.parts:
                used = [
                    library.name for library in part.libraries
                    if library.command != lief.MachO.LoadCommand.TYPE.ID_DYLIB
                ]  # fmt: skip
                assert set(used) == SYSTEM[0] and list(part.build_version.minos)[:2] == OLDEST_MACOS
                assert part.has_code_signature or part.header.cpu_type.name != "ARM64"


def libraries_in(archive):
    """Every library in a wheel or unit, also in the units of a wheel: its path and its bytes."""
    with zipfile.ZipFile(archive) as opened:
        for name in opened.namelist():
            if name.endswith(".fmu"):
                with opened.open(name) as unit:
                    yield from libraries_in(unit)
            elif name.endswith(SUFFIXES):
                yield name, opened.read(name)


def functions_of_fmi(headers, fmi):
    """Names of all functions of a version of FMI, from its header."""
    header = (headers / f"fmi{fmi}Functions.h").read_text(encoding="utf-8")
    return set(re.findall(rf"FMI{fmi}_Export +\w+TYPE +(fmi{fmi}\w+);", header))


# ---- programs of Windows under wine, of Arm Linux under qemu ---------------------------------------------


WINE = shutil.which("wine64", path=f"{os.environ['PATH']}:/usr/lib/wine")
WINE_FOLDER = ROOT / "build/platforms/wine"
"""Wine's copy of Windows, some 700 MB. It is made once, because that takes longer than any test."""
QEMU = shutil.which("qemu-aarch64")
ARM_LIBRARIES = pathlib.Path("/usr/aarch64-linux-gnu")


def windows():
    """The command before a program of Windows, and its environment; None where there is no wine."""
    if WINE is None:
        return None
    return [WINE], os.environ | {"WINEPREFIX": str(WINE_FOLDER), "WINEDEBUG": "-all"}


def arm_linux():
    """The command before a program of Arm Linux, and its environment; None where there is no qemu."""
    if QEMU is None or not ARM_LIBRARIES.is_dir():
        return None
    return [QEMU, "-L", str(ARM_LIBRARIES)], dict(os.environ)
