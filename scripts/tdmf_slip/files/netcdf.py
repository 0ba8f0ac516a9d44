"""Datasets as NetCDF files.

NetCDF is made in memory and goes through Python's own files as everything does: its library knows neither
why a write failed nor names that are no UTF-8.
"""

from collections.abc import Mapping
from pathlib import Path

import xarray
from netCDF4 import Dataset
from xarray.backends import NetCDF4DataStore

from .whole import destination, write_whole

IN_MEMORY = "memory.nc"
"""Name of a NetCDF file that is on no disk."""
FIRST_SIZE = 2**16
"""Bytes of such a one at first; it grows."""


def netcdf_of(data: xarray.Dataset, groups: Mapping[str, xarray.Dataset] | None = None) -> bytes:
    """A dataset as the content of a NetCDF file, with further datasets in groups of the file."""
    file = Dataset(IN_MEMORY, "w", memory=FIRST_SIZE)
    data.dump_to_store(NetCDF4DataStore(file))
    for name, further in (groups or {}).items():
        further.dump_to_store(NetCDF4DataStore(file.createGroup(name)))
    return bytes(file.close())


def write_dataset(
    path: Path, data: xarray.Dataset, groups: Mapping[str, xarray.Dataset] | None = None
) -> None:
    """A dataset as a NetCDF file, with further datasets in groups of the file."""
    write_whole(path, lambda beside: beside.write_bytes(netcdf_of(data, groups)))


def read_dataset(path: Path, group: str = "") -> xarray.Dataset:
    """A dataset from a NetCDF file, or from one of its groups, all of it."""
    file = Dataset(IN_MEMORY, memory=destination(path, str(path)).read_bytes())
    return xarray.load_dataset(NetCDF4DataStore(file[group] if group else file))
