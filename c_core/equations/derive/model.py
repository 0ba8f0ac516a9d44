"""Headers of laws that are functions of C, a topic each, from the table of what C has."""

import inspect
from functools import partial
from typing import Any

from .. import in_c
from . import events
from .c import header, struct
from .expressions import parameters
from .values import Function, given, members


def function(row: in_c.InC) -> Function:
    """Give the function that a row tells; what C makes of others by a law is known to it by its name."""
    result, name = row.declared.split()
    names = parameters(row.call or row.law)

    def arguments(*handed: Any) -> Any:
        known = dict(zip(names, handed, strict=True))
        for made, law in in_c.MADE.items():
            of = [known[parameter] for parameter in parameters(law) if parameter in known]
            if made in known and of:
                known[made] = given(made, law(*of))
        return row.call(*known.values()) if row.call else tuple(known.values())

    types = {name: in_c.TYPES.get(name, "double") for name in [*names, *["written"][: result == "void"]]}
    return Function(result, name, types, row.law, arguments, in_c.FIXED, row.value, row.varied)


def laws(topic: str) -> str:
    """Write the header of a topic."""
    functions = [function(row) for row in in_c.FUNCTIONS[topic]]
    page = inspect.getmodulename(functions[0].law.__code__.co_filename)
    includes = f'#include "{in_c.HEADERS.get(topic, "quantities.h")}"\n\n#include <math.h>\n'
    given = in_c.STRUCTS.get(topic, {})
    records = [struct(law.__doc__, name, members(law)) for name, law in given.items()]
    return header(f"{topic}_laws", f"{page}.py", includes, *records, *(f.c() for f in functions))


FILES = {f"{topic}_laws.h": partial(laws, topic) for topic in in_c.FUNCTIONS}
FILES["guard_laws.h"] = partial(events.guards, in_c.TYPES)
