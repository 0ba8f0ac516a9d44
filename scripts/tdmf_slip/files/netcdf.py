"""Datasets as NetCDF files.

NetCDF is made in memory and goes through Python's own files as everything does: its library knows neither
why a write failed nor names that are no UTF-8.
"""

from pathlib import Path
from typing import Literal

from .datasets import Dataset, NetCDF4DataStore, xarray
from .whole import destination, write_whole

IN_MEMORY = "memory.nc"
"""Name of a NetCDF file that is on no disk."""
FIRST_SIZE = 2**16
"""Bytes of such a one at first; it grows."""


Format = Literal["NETCDF4", "NETCDF3_64BIT_DATA"]
CLASSIC: Format = "NETCDF3_64BIT_DATA"
"""The format in which a variable has one place in the file, so that rows are written where they belong."""


def new_netcdf(form: Format = "NETCDF4") -> Dataset:
    """One in memory, whose `close` gives its bytes."""
    return Dataset(IN_MEMORY, "w", memory=FIRST_SIZE, format=form)


def netcdf_of(data: xarray.Dataset, form: Format = "NETCDF4") -> bytes:
    """A dataset as the content of a NetCDF file."""
    dataset = new_netcdf(form)
    data.dump_to_store(NetCDF4DataStore(dataset))
    return bytes(dataset.close())


def write_dataset(path: Path, data: xarray.Dataset, form: Format = "NETCDF4") -> None:
    """A dataset as NetCDF."""
    write_whole(path, lambda beside: beside.write_bytes(netcdf_of(data, form)))


def read_dataset(path: Path) -> xarray.Dataset:
    """A dataset from a NetCDF file, all of it."""
    content = destination(path, str(path)).read_bytes()
    return xarray.load_dataset(NetCDF4DataStore(Dataset(IN_MEMORY, memory=content)))
