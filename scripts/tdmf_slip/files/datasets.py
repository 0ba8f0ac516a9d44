"""The libraries of datasets and NetCDF, which the extra `data` brings: all else loads them from here."""

from ..errors import InputError

try:
    import xarray as xarray
    from netCDF4 import Dataset as Dataset
    from xarray.backends import NetCDF4DataStore as NetCDF4DataStore
except ImportError as problem:
    raise InputError(
        f"datasets and NetCDF files need xarray and netCDF4, of which one is missing ({problem}); "
        "install them by: pip install 'tdmf-slip[data]'"
    ) from None
