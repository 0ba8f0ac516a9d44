"""Pictures of runs, strides, maps and the model, and the style that all of them share."""

from ..errors import InputError

try:
    import matplotlib  # noqa: F401 # only whether it is there
except ImportError:
    raise InputError(
        "pictures need Matplotlib, which is missing; install it by: pip install 'tdmf-slip[plots]'"
    ) from None
