"""Headers of laws that are functions of C, a topic each, from the table of what C has."""

import inspect
from functools import partial

from .. import in_c
from .c import header
from .values import Function


def laws(topic: str) -> str:
    """Write the header of a topic."""
    functions = [Function(row) for row in in_c.FUNCTIONS[topic]]
    page = inspect.getmodulename(functions[0].law.__code__.co_filename)
    includes = '#include "quantities.h"\n\n#include <math.h>\n'
    return header(f"{topic}_laws", f"{page}.py", includes, *(f.c() for f in functions))


FILES = {f"{topic}_laws.h": partial(laws, topic) for topic in in_c.FUNCTIONS}
