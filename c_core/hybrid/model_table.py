"""The table of a page: names, units, bounds, meanings and roles of all that a model has, as plain data."""

from .expressions import forget_expressions
from .quantities import range_of


def starts_of(page):
    """States that take a start value: those of the coordinates in which runs start, and others that move."""
    of_start = page.modes[page.keys[0][0]].of
    moving = set()
    for key in page.keys:
        forget_expressions()
        moving |= page.rates(key).keys()
    written = {function.into for function in page.observed.values()}
    named = {name for name, q in page.states.items() if of_start in (q.of or ())}
    named |= {name for name in moving - written if page.states[name].of is None}
    rates = {f"{name}_rate" for name in page.inputs}
    return named - rates - {*page.inputs, *page.clocks}


def table_of(page):
    """Declarations of a page whose C was generated, in the order of their numbers in C."""
    starts = starts_of(page)

    def quantity(name, q, role):
        least, most = range_of(q)
        return {
            "name": name, "public": page.model.public(name), "unit": q.unit, "meaning": q.meaning,
            "start": q.value, "least": least, "most": most, "role": role,
            "is_named": page.model.declared_name(name) is not None, "is_boolean": q.values is bool,
            "letters": q.values[1] if isinstance(q.values, tuple) else "",
        }  # fmt: skip

    def role_of(name, q):
        return "start" if name in starts else q.role if q.is_input or q.is_clock else "held"

    return {
        "name": page.model.__name__,
        "c_name": page.c,
        "about": " ".join((page.model.__doc__ or "").split()),
        "parameters": [quantity(name, q, q.role) for name, q in page.parameters.items()],
        "states": [quantity(name, q, role_of(name, q)) for name, q in page.states.items()],
        "modes": [[key[0], *(f"{word}={value}" for word, value in key[1])] for key in page.keys],
        "events": list(page.events),
        "sections": [
            {"name": name, "event": of.event, "coordinates": list(of.coordinates)}
            for name, of in page.sections.items()
        ],
        "requirements": [
            {"variable": of.of_variable, "allowed": of.allowed}
            for of in page.model.marked("is_required").values()
        ],
        "outputs": [
            {
                "name": name, "public": page.model.public(name), "unit": of.unit,
                "meaning": " ".join((of.__doc__ or "").split()).removesuffix("."),
                "is_enumeration": isinstance(kind, tuple) and kind[0] != "letters",
            }
            for name, of, kind in ((n, f, f.kind_of_value) for n, f in page.outputs.items())
        ],
    }  # fmt: skip
