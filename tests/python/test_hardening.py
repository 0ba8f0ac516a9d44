"""Binaries of the unit and the library are hardened, as far as their platform has it."""

import pathlib
import re
import struct
import sys

import pytest
import tdmf_slip
from binaries import libraries_in, lief
from conftest import ROOT
from tdmf_slip.library.binding import library_path


def given_out():
    """The wheel and the units for all platforms; ./scripts/release makes them."""
    return [*(ROOT / "dist").glob("*.whl"), *(ROOT / "dist").glob("*.fmu")]


PAGE = 4096
ENDBR64 = bytes.fromhex("f30f1efa")
# bti c, and paciasp, which signs the return address and marks the place, too
BRANCH_TARGETS = (0xD503245F, 0xD503233F)


def words_of(code):
    return struct.unpack(f"<{len(code) // 4}I", code[: len(code) // 4 * 4])


def largest_frame_opened_at_once(architecture, code):
    """Most that one instruction takes from the stack pointer, in bytes."""
    if architecture == lief.ELF.ARCH.X86_64:  # sub rsp, imm32; a frame of ours is below a MiB
        taken = [int.from_bytes(found, "little") for found in re.findall(rb"\x48\x81\xec(....)", code, re.S)]
        return max((size for size in taken if size < 2**20), default=0)
    shifted = [word for word in words_of(code) if word & 0xFFC003FF == 0xD14003FF]  # sub sp, sp, #imm, lsl 12
    return max((PAGE * (word >> 10 & 0xFFF) for word in shifted), default=0)


def is_marked(architecture, start):
    if architecture == lief.ELF.ARCH.X86_64:
        return start[:4] == ENDBR64
    return words_of(start[:4])[0] in BRANCH_TARGETS


def assert_code_is_hardened(name, elf):
    """Jumps arrive at marked places, and no frame skips a page of the stack."""
    architecture = elf.header.machine_type
    if architecture not in (lief.ELF.ARCH.X86_64, lief.ELF.ARCH.AARCH64):
        return
    functions = [
        symbol
        for symbol in elf.exported_symbols
        if re.match("tdmf_|fmi[23]", symbol.name) and symbol.is_function
    ]
    assert len(functions) > 20, name
    for function in functions:
        start = bytes(elf.get_content_from_virtual_address(function.value, 4))
        assert is_marked(architecture, start), (name, function.name)
    code = bytes(elf.get_section(".text").content)
    assert largest_frame_opened_at_once(architecture, code) <= PAGE, name


def assert_elf_is_hardened(name, elf):
    assert_code_is_hardened(name, elf)
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
    found = [pair for unit in folder.glob("*.fmu") for pair in libraries_in(unit) if pair[0].endswith(".so")]
    assert len(found) >= 2
    for name, data in found:
        assert_is_hardened(name, data)


@pytest.mark.skipif(
    not given_out(), reason="NOT TESTED: hardening of what is given out; ./scripts/release makes it"
)
def test_what_is_given_out_is_hardened():
    found = [pair for archive in given_out() for pair in libraries_in(archive)]
    assert len(found) >= 3 + 2 * 6
    for name, data in found:
        assert_is_hardened(name, data)
