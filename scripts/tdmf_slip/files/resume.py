"""Long work on file, block by block, so that a job that is killed loses no block that was done.

While work is under way, each block that is done is a NetCDF file in a folder beside the result, as
`map.nc.parts` beside `map.nc`. When all blocks are done, the result is written and the folder goes.
"""

import contextlib
import json
import secrets
import shutil
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import InputError, RunError
from ..terminal.in_blocks import in_blocks
from .whole import check_folder

if TYPE_CHECKING:
    import xarray

Place = Mapping[str, int | Sequence[int]]
"""Indices of a block along some of the dimensions."""
NOT_YET = -1
"""Fate of a start, or of a stride, that has not been computed."""
PLACE = "place"
"""Attribute of a block: its place as JSON."""


class Resumed:
    """A result that is filled in block by block, on file where a path is given.

    Parameters
    ----------
    path : Path or None
        Where the result goes.
    blank : xarray.Dataset
        The result before any work. On file, only the same coordinates, attributes and variables are accepted.
    what : str
        The result in messages, as "map of fates".
    working : sequence of str
        Variables of blocks that the whole result does not have.
    """

    def __init__(
        self, path: Path | None, blank: "xarray.Dataset", what: str, working: Sequence[str] = ()
    ) -> None:
        self.path, self.what, self.data = path, what, blank
        self.done: list[Place] = []
        self.is_whole = path is not None and path.exists()
        if path is None:
            return
        self.folder = path.with_name(f"{path.name}.parts")
        if self.is_whole:
            self.data = self._read(path)
            self._check(path, self.data, blank.drop_vars(working))
        else:
            check_folder(self.folder, self.what)
            for part in sorted(self.folder.glob("*.nc")):
                self._take(part)

    def group(self, name: str) -> "xarray.Dataset":
        """A further dataset of the whole result, by its group in the file."""
        from .netcdf import read_dataset  # netCDF4 is slow to load

        assert self.path is not None
        try:
            return read_dataset(self.path, name)
        except IndexError:
            raise self._refusal(self.path, f"without a group {name}") from None

    def _take(self, part: Path) -> None:
        """Fill in a block that is done."""
        found = self._read(part)
        try:
            place = json.loads(found.attrs[PLACE])
            wanted = self.data.isel(place)
        except (KeyError, ValueError, IndexError, TypeError):
            raise self._refusal(part, "without its place") from None
        self._check(part, found, wanted)
        self._fill(place, {name: found[name].values for name in wanted.data_vars})

    def _read(self, path: Path) -> "xarray.Dataset":
        from .netcdf import read_dataset  # netCDF4 is slow to load

        try:
            return read_dataset(path)
        except (OSError, ValueError) as problem:
            why = getattr(problem, "strerror", None) or str(problem)
            raise self._refusal(path, f"no NetCDF file, {why}") from None

    def _check(self, path: Path, found: "xarray.Dataset", wanted: "xarray.Dataset") -> None:
        if "result" not in found.attrs:
            raise self._refusal(path, "made by another program or an earlier version")
        if found.attrs["result"] != wanted.attrs["result"]:
            raise self._refusal(path, f"holds a {found.attrs['result']}")
        difference = next(_differences(found, wanted), None)
        if difference is not None:
            raise self._refusal(path, difference)

    def _refusal(self, path: Path, why: str) -> InputError:
        return InputError(
            f"{path}: not this {self.what}: {why}; give another file name, or delete it to compute it anew"
        )

    def _fill(self, place: Place, values: Mapping[Any, Any]) -> None:
        for name, array in values.items():
            self.data[name][dict(place)] = array
        self.done.append(place)

    def write(self, place: Place, values: Mapping[Any, Any]) -> None:
        """Fill in a block: arrays by the names of the variables."""
        self._fill(place, values)
        if self.path is not None:
            from .netcdf import write_dataset  # netCDF4 is slow to load

            self.folder.mkdir(exist_ok=True)
            part = self.data.isel(place).assign_attrs({PLACE: json.dumps(place)})
            file = self.folder / f"{secrets.token_hex(8)}.nc"
            try:
                write_dataset(file, part)
            except RunError as problem:  # as on a full disk
                with contextlib.suppress(OSError):  # blocks that were done stay
                    self.folder.rmdir()
                raise RunError(f"{self.path}{str(problem).removeprefix(str(file))}") from problem

    def fill_rows(
        self,
        work: Callable[[list[int]], Mapping[Any, Any]],
        at_once: int,
        what: str,
        unit: str,
        executor: Executor | None,
        progress: bool,
    ) -> None:
        """Fill in the rows that have fates not known yet: `work` gives arrays by name for some of them."""
        fate = self.data["fate"]
        missing = [row for row, of in enumerate(fate.values) if (of == NOT_YET).any()]
        blocks = [missing[first : first + at_once] for first in range(0, len(missing), at_once)]
        size = fate[0].size
        sizes, done = [len(block) * size for block in blocks], (len(fate) - len(missing)) * size
        with in_blocks(work, blocks, what, unit, executor, progress, sizes=sizes, done=done) as results:
            for number, arrays in results:
                self.write({str(fate.dims[0]): blocks[number]}, arrays)

    def finish(self, data: "xarray.Dataset", groups: "Mapping[str, xarray.Dataset] | None" = None) -> None:
        """Write the result, with further datasets in groups of the file; the blocks go."""
        if self.path is not None:
            from .netcdf import write_dataset  # netCDF4 is slow to load

            write_dataset(self.path, data, groups)
            shutil.rmtree(self.folder, ignore_errors=True)


def refuse_resumable(path: Path) -> None:
    """Refuse, before any work, to write something else over results on file that took long."""
    from .netcdf import read_dataset  # netCDF4 is slow to load

    try:
        data = read_dataset(path)
    except (OSError, ValueError):
        return
    kind = data.attrs.get("result")
    if kind in ("basin", "viability") or (kind == "sweep" and "word" in data and data["word"].ndim > 1):
        raise InputError(f"{path}: holds a {kind}; give another file name")


def _differences(found: "xarray.Dataset", wanted: "xarray.Dataset") -> Iterator[str]:
    """Differences in words: coordinates, variables and attributes that are wanted."""
    for name, values in wanted.coords.items():
        if name not in found.coords or not np.array_equal(found[name].values, values.values):
            yield f"other values of {name}"
    for name, variable in wanted.data_vars.items():
        if name not in found or found[name].dims != variable.dims:
            yield f"without a variable {name} over {', '.join(map(str, variable.dims))}"
    for name in wanted.attrs:
        if name == "runner":
            yield from _other_values(found.attrs.get(name), wanted.attrs[name])
        elif not _same(found.attrs, wanted.attrs, name):
            yield f"another {name}"


def _other_values(found: Any, wanted: str) -> Iterator[str]:
    """Names whose values differ between two runners."""
    if found != wanted:
        try:
            there, here = json.loads(found), json.loads(wanted)
            yield from (f"another {name}" for name in here if there.get(name) != here[name])
        except (ValueError, TypeError, AttributeError):
            pass
        yield "another runner"


def _same(found: Mapping[Any, Any], wanted: Mapping[Any, Any], name: Hashable) -> bool:
    """True if an attribute agrees. Numbers may differ by rounding, as between two machines."""
    value, there = wanted[name], found.get(name, "")
    if isinstance(value, str):
        return isinstance(there, str) and there == value
    if np.asarray(there).dtype.kind not in "iuf" or np.shape(there) != np.shape(value):
        return False
    return np.allclose(there, value, rtol=1e-9, atol=1e-12)
