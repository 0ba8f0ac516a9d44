"""The language of pages, and the generator of C99 that reads them: hybrid models as plain Python classes.

A page declares quantities, modes with their rates, events with their decisions, and outputs. `derive`
writes the C of a page, which the driver in hybrid/kernel runs. Neither knows what a model is about.
"""

from .errors import PageError
from .generate import derive
from .model import *  # noqa: F403
from .model import __all__ as words

__all__ = ["PageError", "derive", *words]
