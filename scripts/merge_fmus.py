#!/usr/bin/env python3
"""Put the binaries of several platforms into one unit per FMI version.

    merge_fmus.py TARGET BUILD...    folders with TDMF_SLIP.fmu and TDMF_SLIP_FMI3.fmu, each of one platform

Everything but the binaries is taken from the first. Where FMI 2.0 has one folder for two processors, macOS
gets a universal file; elsewhere the folder means x86-64 and the other is left out. The same input gives the
same bytes: entries are in order, and have the time of SOURCE_DATE_EPOCH, or else the earliest of a zip file.
"""

import argparse
import os
import pathlib
import struct
import time
import zipfile

FILES = ("TDMF_SLIP.fmu", "TDMF_SLIP_FMI3.fmu")
LIBRARIES = (".so", ".dll", ".dylib")
X86_64 = "x86_64"
MACH_O_64 = 0xFEEDFACF
UNIVERSAL = 0xCAFEBABE
UNIVERSAL_ALIGNMENT = 14
"""As a power of two: the page of Apple's processors."""


def universal(slices):
    """A universal Mach-O file (mach-o/fat.h) of these Mach-O files, one for each processor."""
    page = 1 << UNIVERSAL_ALIGNMENT
    header = struct.pack(">II", UNIVERSAL, len(slices))
    content = b""
    offset = page
    for data in slices:
        magic, processor, kind = struct.unpack_from("<III", data)
        if magic != MACH_O_64:
            raise SystemExit("merge_fmus.py: a macOS binary is no 64-bit Mach-O file")
        header += struct.pack(">5I", processor, kind, offset, len(data), UNIVERSAL_ALIGNMENT)
        padded = -(-len(data) // page) * page
        content += data.ljust(padded, b"\0")
        offset += padded
    return header.ljust(page, b"\0") + content


def binaries(unit):
    """The libraries of a unit by their name in it, without what linkers put beside them."""
    with zipfile.ZipFile(unit) as file:
        names = [n for n in file.namelist() if n.startswith("binaries/") and n.endswith(LIBRARIES)]
        return {name: file.read(name) for name in names}


def is_for_x86_64(build):
    """Whether a build folder is that of an x86-64 platform: build/platforms/x86_64-linux/fmu_src."""
    return any(part.startswith(X86_64) for part in build.parts)


def collect(builds, file):
    """All binaries by name, from the builds' units of this file name."""
    found = {}
    for build in builds:
        for name, data in binaries(build / file).items():
            found.setdefault(name, []).append((is_for_x86_64(build), data))
    chosen = {}
    for name, candidates in found.items():
        if len(candidates) == 1:
            chosen[name] = candidates[0][1]
        elif name.endswith(".dylib"):
            chosen[name] = universal([data for _, data in candidates])
        else:
            (chosen[name],) = (data for for_x86_64, data in candidates if for_x86_64)
    return chosen


def entry_time():
    """The time that every entry has."""
    earliest = 315532800  # 1980-01-01
    return time.gmtime(max(earliest, int(os.environ.get("SOURCE_DATE_EPOCH", earliest))))[:6]


def merge(builds, target, file):
    """Write the merged unit."""
    with zipfile.ZipFile(builds[0] / file) as first:
        names = [name for name in first.namelist() if not name.endswith("/")]
        entries = {name: first.read(name) for name in names if not name.startswith("binaries/")}
    entries |= collect(builds, file)
    with zipfile.ZipFile(target / file, "w") as merged:
        for name, data in sorted(entries.items()):
            entry = zipfile.ZipInfo(name, entry_time())
            entry.external_attr = 0o100644 << 16
            entry.create_system = 3  # Unix, whatever this one is
            merged.writestr(entry, data, zipfile.ZIP_DEFLATED)


def main():
    """Run the command."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("target", type=pathlib.Path)
    parser.add_argument("builds", type=pathlib.Path, nargs="+", metavar="build")
    arguments = parser.parse_args()
    for file in FILES:
        merge(arguments.builds, arguments.target, file)


if __name__ == "__main__":
    main()
