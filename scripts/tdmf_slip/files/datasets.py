"""The libraries of datasets and NetCDF, which the extra `data` brings: all else loads them from here."""

from ..errors import InputError

try:
    import xarray as xarray
    from netCDF4 import Dataset as Dataset
    from xarray.backends import NetCDF4DataStore as NetCDF4DataStore
except ImportError as problem:
    raise InputError(
        "datasets and NetCDF files need xarray and netCDF4 (the extra data), of which one is missing "
        f"({problem}); install them by: pip install xarray netCDF4"
    ) from None
