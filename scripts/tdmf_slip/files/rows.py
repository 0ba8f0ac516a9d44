"""Rows of a result written into its NetCDF file, so that a long work does not write the whole each time.

In the classic format (CDF-5, see the NetCDF Users Guide, appendix "File Format Specifications") each variable
without an unlimited dimension has one offset, big-endian and without gaps, which the header tells.
"""

import os
import struct
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from ..errors import InputError
from ..uninterrupted import uninterrupted
from .datasets import xarray
from .netcdf import CLASSIC, write_dataset
from .whole import destination

MAGIC = b"CDF\x05"
SIZES: Mapping[int, int] = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8, 7: 1, 8: 2, 9: 4, 10: 8, 11: 8}
"""Bytes of a value, by the number of its type."""


class RowFile:
    """A NetCDF file that holds a dataset, row by row as they are ready; readable at any time."""

    def __init__(self, path: Path, data: xarray.Dataset) -> None:
        """Begin it, unless a file of this layout is there."""
        self.path, self.data = path, data
        resolved = destination(path, str(path))
        if not resolved.exists() or _start_of(resolved, len(MAGIC)) != MAGIC:
            write_dataset(path, data, CLASSIC)
        self.offsets = _offsets(resolved)

    def write(self, names: Sequence[str], rows: Sequence[int]) -> None:
        """Write rows of variables, each whole before the next: what tells of a row is ready comes last."""
        uninterrupted(lambda: self._write(names, rows))

    def _write(self, names: Sequence[str], rows: Sequence[int]) -> None:
        try:
            with destination(self.path, str(self.path)).open("r+b") as file:
                for name in names:
                    values = self.data[name].values
                    for row in rows:
                        file.seek(self.offsets[name] + row * values[row].nbytes)
                        file.write(
                            np.ascontiguousarray(values[row], values.dtype.newbyteorder(">")).tobytes()
                        )
                    file.flush()
                    os.fsync(file.fileno())
        except OSError as problem:
            raise InputError(f"{self.path}: cannot be written: {problem.strerror or problem}") from problem


def _start_of(resolved: Path, count: int) -> bytes:
    with resolved.open("rb") as file:
        return file.read(count)


def _offsets(resolved: Path) -> dict[str, int]:
    """Where each variable begins, bytes from the file's beginning on."""
    header = _Header(resolved.read_bytes())
    header.at = len(MAGIC) + 8
    for _ in range(header.count()):
        header.name()
        header.whole()
    header.skip_attributes()
    offsets = {}
    for _ in range(header.count()):
        name = header.name()
        for _ in range(header.whole()):
            header.whole()
        header.skip_attributes()
        header.at += 4 + 8
        offsets[name] = header.whole()
    return offsets


class _Header:
    """Of a file of the classic format, read from one offset on."""

    def __init__(self, content: bytes) -> None:
        self.content, self.at = content, 0

    def whole(self, form: str = ">q") -> int:
        (value,) = struct.unpack_from(form, self.content, self.at)
        self.at += struct.calcsize(form)
        return int(value)

    def count(self) -> int:
        """Of a list, whose tag comes before."""
        self.whole(">i")
        return self.whole()

    def name(self) -> str:
        length = self.whole()
        text = self.content[self.at : self.at + length].decode()
        self.at += _padded(length)
        return text

    def skip_attributes(self) -> None:
        for _ in range(self.count()):
            self.name()
            size = SIZES[self.whole(">i")]
            count = self.whole()
            self.at += _padded(size * count)


def _padded(length: int) -> int:
    return -(-length // 4) * 4
