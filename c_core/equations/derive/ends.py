"""From what a motion starts with to its series and back: the coordinates of a step, in C.

A page's `start` makes the states of a motion of its coordinates, and its `end` is the inverse; here are C of
the latter, for any width and varied, and the copies between the coordinates and the structs of the model.
"""

from collections.abc import Callable
from types import SimpleNamespace as Record
from typing import Any

from .. import flight, ground
from .c import c_text, comment, header
from .expressions import Expression, derivative, forget, leaves, lift, symbol, trace

# The struct that the model has the coordinates in, and the cases of the page's `end`.
MOTIONS: dict[str, tuple[Any, str, dict[str, dict[str, str]]]] = {
    "flight": (flight, "tdmf_flying", {"flight": {}}),
    "ground": (ground, "tdmf_standing", {"stick": {"contact": "stick"}, "ground": {"contact": "slip"}}),
}


def coordinates(page: Any) -> list[str]:
    """Name what a motion starts with."""
    code = page.start.__code__
    return list(code.co_varnames[: code.co_argcount])


def traced(page: Any, told: dict[str, str]) -> dict[str, Expression]:
    """Give the coordinates by the states, which are symbols."""
    forget()
    given = {name: symbol("start->" + name) for name in coordinates(page)}
    states = [str(name) for name in vars(trace(page.start, **given))]
    forget()
    ends = trace(page.end, Record(**{name: symbol(name) for name in states}), **told)
    return {name: lift(value) for name, value in vars(ends).items()}


def real(value: Expression) -> str:
    """Write a value for any width."""
    return f"broadcast({c_text(value)})" if value.operation == "number" else c_text(value)


def ends() -> str:
    """Write where a motion leads, for any width."""
    parts = []
    for motion, (page, _, cases) in MOTIONS.items():
        for case, told in cases.items():
            values = traced(page, told)
            lines = [
                f"static inline void end_{case}(const {motion}_series *s, const elapsed_time *elapsed, "
                f"int order, {motion}_start *at) {{",
                *(
                    f"const real {state.value} = value_at(s->{state.value}, elapsed, order);"
                    for state in leaves(values.values())
                ),
                *(f"at->{name} = {real(value)};" for name, value in values.items()),
                "}\n",
            ]
            parts.append(comment(page.end.__doc__) + "\n".join(lines))
    includes = '#include "motion_series.h"\n#include "step_sums.h"\n'
    return header("motion_ends", "flight.py and ground.py", includes, *parts)


def varied(page: Any, motion: str, case: str, told: dict[str, str]) -> str:
    """Write the change of where a motion leads."""
    values = traced(page, told)
    changes = {leaf: symbol(f"d_{leaf.value}") for leaf in leaves(values.values())}
    changed = {name: derivative(value, changes) for name, value in values.items()}
    asked = [str(leaf.value) for leaf in leaves(changed.values())]
    lines = [
        f"static inline void vary_end_{case}(const {motion}_series *s, const {motion}_variation *t, "
        f"int order, double time, {motion}_start *d_at) {{",
        *(["(void)s;"] if all(name.startswith("d_") for name in asked) else []),
        *(
            f"const double {name} = series_at({'t' if name.startswith('d_') else 's'}->"
            f"{name.removeprefix('d_')}, order, time);"
            for name in asked
        ),
        *(f"d_at->{name} = {c_text(value)};" for name, value in changed.items()),
        "}\n",
    ]
    return "/* Its change, at a time. */\n" + "\n".join(lines)


def copied(motion: str, page: Any, struct: str) -> str:
    """Write the copies between coordinates and a struct of the model."""
    names = coordinates(page)
    lines = [
        f"static inline {motion}_start {motion}_start_of(const {struct} *at) {{",
        f"const {motion}_start start = {{{', '.join('at->' + name for name in names)}}};",
        "return start;",
        "}",
        "",
        f"static inline void set_{motion}(const {motion}_start *start, {struct} *at) {{",
        *(f"at->{name} = start->{name};" for name in names),
        "}\n",
    ]
    return "/* What a motion starts with, of the model's coordinates, and back. */\n" + "\n".join(lines)


def copies() -> str:
    """Write the copies between the coordinates and the structs of the model, and the changes."""
    parts = []
    for motion, (page, struct, cases) in MOTIONS.items():
        parts += [copied(motion, page, struct), *(varied(page, motion, *case) for case in cases.items())]
    includes = '#include "coordinate_laws.h"\n#include "motion_series.h"\n#include "series_sums.h"\n'
    return header("motion_coordinates", "flight.py and ground.py", includes, *parts)


FILES: dict[str, Callable[[], str]] = {"motion_ends.h": ends, "motion_coordinates.h": copies}
