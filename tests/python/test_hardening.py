"""Binaries of the unit and the library are hardened, as far as their platform has it."""

import pathlib
import sys
import zipfile

import pytest
import tdmf_slip
from tdmf_slip.library.binding import library_path

lief = pytest.importorskip("lief", reason="NOT TESTED: hardening, lief is not installed")

ROOT = pathlib.Path(__file__).resolve().parents[2]
SUFFIXES = (".so", ".dll", ".dylib")


def binaries(archive):
    """Every library in a wheel or unit, also in the units of a wheel, by its path."""
    with zipfile.ZipFile(archive) as opened:
        for name in opened.namelist():
            if name.endswith(".fmu"):
                with opened.open(name) as unit:
                    yield from binaries(unit)
            elif name.endswith(SUFFIXES):
                yield name, opened.read(name)


def given_out():
    """The wheel and the units for all platforms; ./scripts/release makes them."""
    return [*(ROOT / "dist").glob("*.whl"), *(ROOT / "dist").glob("*.fmu")]


def assert_elf_is_hardened(name, elf):
    flags = {flag for entry in elf.dynamic_entries if hasattr(entry, "flags") for flag in entry.flags}
    assert lief.ELF.DynamicEntryFlags.FLAG.NOW in flags, name
    kinds = lief.ELF.Segment.TYPE
    segments = {segment.type: segment for segment in elf.segments}
    assert kinds.GNU_RELRO in segments, name
    executable, writable = lief.ELF.Segment.FLAGS.X, lief.ELF.Segment.FLAGS.W
    assert kinds.GNU_STACK in segments and not segments[kinds.GNU_STACK].has(executable), name
    assert not any(s.has(executable) and s.has(writable) for s in elf.segments), name
    assert not elf.has(lief.ELF.DynamicEntry.TAG.TEXTREL), name
    imported = {symbol.name for symbol in elf.imported_symbols}
    assert "__stack_chk_fail" in imported, name
    assert {"__snprintf_chk", "__vsnprintf_chk"} & imported, name


def assert_is_hardened(name, data):
    binary = lief.parse(list(data))
    if isinstance(binary, lief.ELF.Binary):
        assert_elf_is_hardened(name, binary)
    elif isinstance(binary, lief.PE.Binary):
        kinds = lief.PE.OptionalHeader.DLL_CHARACTERISTICS
        for kind in (kinds.DYNAMIC_BASE, kinds.NX_COMPAT, kinds.HIGH_ENTROPY_VA):
            assert binary.optional_header.has(kind), (name, kind)
    else:
        assert "___stack_chk_fail" in {symbol.name for symbol in binary.imported_symbols}, name


@pytest.mark.skipif(
    sys.platform != "linux", reason="the library's and the unit's files are ELF on Linux only"
)
def test_what_is_built_here_is_hardened():
    assert_is_hardened("library", pathlib.Path(library_path()).read_bytes())
    folder = pathlib.Path(tdmf_slip.fmu_path()).parent
    found = [pair for unit in folder.glob("*.fmu") for pair in binaries(unit) if pair[0].endswith(".so")]
    assert len(found) >= 2
    for name, data in found:
        assert_is_hardened(name, data)


@pytest.mark.skipif(
    not given_out(), reason="NOT TESTED: hardening of what is given out; ./scripts/release makes it"
)
def test_what_is_given_out_is_hardened():
    found = [pair for archive in given_out() for pair in binaries(archive)]
    assert len(found) >= 3 + 2 * 6
    for name, data in found:
        assert_is_hardened(name, data)
