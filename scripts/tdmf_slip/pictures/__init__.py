"""Pictures of runs, strides, maps and the model, and the style that all of them share."""

from ..errors import InputError

try:
    import matplotlib  # noqa: F401 # only whether it is there
except ImportError:
    raise InputError(
        "pictures need Matplotlib (the extra plots), which is missing; install it by: pip install matplotlib"
    ) from None
except Exception as problem:  # of the variable MPLBACKEND, or of a file of settings
    why = " ".join(str(problem).split())
    raise InputError(f"pictures: Matplotlib does not start: {why}; check its settings") from problem
