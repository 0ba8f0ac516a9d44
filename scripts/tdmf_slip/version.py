"""The version of this package."""

from importlib.metadata import PackageNotFoundError, version

try:
    __version__ = version("tdmf-slip")
except PackageNotFoundError:  # used from a source tree that is not installed
    __version__ = "0+unknown"
