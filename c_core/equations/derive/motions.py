"""Headers of the motions, from the table of these: series, guards as series, where motions begin and lead."""

import re
from collections.abc import Callable
from functools import partial
from types import SimpleNamespace as Record
from typing import Any

from ..in_c import InC
from ..motions import COORDINATES, FLIGHT, GUARDS, HEADERS, MOTIONS, OF_NUMBERS, STRUCTS
from .c import comment, header, struct
from .expressions import Expression, begin_anew, lift, parameters, symbol, trace
from .motion import Family, Motion, end, series_of, states_of, structs
from .series import Expansion, kind_of
from .values import Function, members

LAW = """\
{what}static inline void expand_{name}({declared}, int order, real {name}[SERIES_TERMS]) {{
{local}int k = 0;
do {{
{step}
}} while (++k <= order);
{after}}}
"""


def of_cases(mode: str, name: str, cases: list[str]) -> str:
    """Write a header of some cases."""
    family, include = MOTIONS[name], "series_products.h" if mode == name else f"{name}_series.h"
    parts = [structs(family), *laws_of_coefficients(family)] if mode == name else []
    parts += [Motion(family, case).source() for case in cases]
    parts += [Motion(family, case).variation() for case in cases]
    return header(f"{mode}_series", f"{name}.py", f'#include "{include}"\n', *parts)


def laws_of_coefficients(family: Family) -> list[str]:
    """Write laws of what a motion depends on: how fast it is, and what drifts in any width."""
    of, drifting = f"{family.name}_coefficients *", [n for n, word in family.ramps.items() if word == "drift"]

    def drift(c: Any, elapsed: Any) -> Record:
        """What drifts, some time later."""
        return Record(**{name: getattr(c, name) + elapsed * getattr(c, f"{name}_rate") for name in drifting})

    rows = [InC(f"real fastest_{family.name}", family.page.fastest, varied=False)]
    rows += [InC(f"void drift_{family.name}", drift, varied=False)] if drifting else []
    return [Function(row, {"c": f"const {of}", "written": of}, "real").c() for row in rows]


def copies() -> str:
    """Write copies between what motions start with and the coordinates of the model."""
    parts = []
    for name, family in MOTIONS.items():

        def same(at: Any, *, names: str = family.start) -> Record:
            """What a motion starts with, of the model's coordinates, or back."""
            return Record(**{name: getattr(at, name) for name in names.split()})

        model, start = COORDINATES[name], f"{name}_start"
        to_start = InC(f"{start} {start}_of", same, varied=False)
        parts.append(Function(to_start, {"at": f"const {model} *"}).c())
        back, types = InC(f"void set_{name}", same, varied=False), {"at": f"const {start} *"}
        parts.append(Function(back, types | {"written": f"{model} *"}).c())
    includes = "".join(f'#include "{name}.h"\n' for name in ("coordinate_laws", "motion_series"))
    return header("motion_coordinates", "flight.py and ground.py", includes, *parts)


def ends() -> str:
    """Write where motions lead, and what the hip does on the way in flight."""
    includes = "".join(f'#include "{name}.h"\n' for name in ("motion_series", "series_products", "step_sums"))
    given = {"c": ("const flight_coefficients *c", members(FLIGHT.constants))}
    torque = law_series(FLIGHT.page.hip_torque, series_of(FLIGHT), given)
    ends = map(end, MOTIONS.values())
    return header("motion_ends", "flight.py and ground.py", includes, *ends, torque, work(FLIGHT))


def work(family: Family) -> str:
    """Write the work that the hip does in a step up to a time, by what is at its start and integrals."""

    def in_step(c: Any, s: Any, elapsed: Any, order: Any, turned: Any) -> Any:
        states, known_to = states_of(family), {name: symbol("order - 1") for name in family.stored.split()}
        start = Record(**{name: symbol(f"s->{name}[0]") for name in states})
        known_to |= dict.fromkeys(states, order)
        integrals = {n: Expression("integral_to", getattr(s, n), elapsed, k) for n, k in known_to.items()}
        return c, start, Record(**integrals), turned, symbol("elapsed->power[1]")

    types = {"c": f"const {family.name}_coefficients *", "s": f"const {family.name}_series *"}
    types |= {"elapsed": "const elapsed_time *", "order": "int"}
    row = InC(f"real {family.name}_work", family.page.work, in_step, varied=False)
    return Function(row, types, "real").c()


def guard_series() -> str:
    """Write guards that are made of series of the motion, and what they are made of."""
    given = [struct(law.__doc__, name, members(law), "real") for name, law in STRUCTS.values()]
    structs = {name: (f"const {type_} *{name}", members(law)) for name, (type_, law) in STRUCTS.items()}
    series = {guard.__name__ for guard in GUARDS}.union(*map(series_of, MOTIONS.values()))
    laws = [law_series(law, series, structs) for law in GUARDS]
    for law in OF_NUMBERS:
        types = {name: f"const {STRUCTS[name][0]} *" for name in parameters(law) if name in STRUCTS}
        laws.append(Function(InC(f"real {law.__name__}", law, varied=False), types, "real").c())
    pages = "ground.py, flight.py, friction.py and hip.py"
    return header("guard_series", pages, '#include "series_products.h"\n', *given, *laws)


def law_series(law: Callable[..., Any], series: set[str], structs: dict[str, tuple[str, list[str]]]) -> str:
    """Write a function that expands a law of series, of what is constant and of structs of that.

    A member of these that has a rate beside it drifts; an angle turns by the series of its rate. A law
    that is a product of series is made at once, after these.
    """
    begin_anew()
    name, handed, declared = law.__name__, [], {}
    for n in parameters(law):
        declared[n], members = structs.get(n, (f"const real *{n}" if n in series else f"real {n}", []))
        drifts = {m: symbol(f"{n}->{m}_rate", constant=True) for m in members if f"{m}_rate" in members}
        marks = {m: {"ramp": rate, "word": "drift"} for m, rate in drifts.items()}
        record = {m: symbol(f"{n}->{m}", **marks.get(m, {"constant": True})) for m in members}
        handed.append(Record(**record) if members else symbol(n, constant=n not in series))
    quantity = lift(trace(law, *handed))
    rates = {symbol(n): symbol(f"{n}_rate") for n in declared if {n, f"{n}_rate"} <= series}
    expansion = Expansion({name: quantity}, rates)
    steps, after = expansion.quantities(), ""
    if kind_of(quantity) == "product":
        a, b = (expansion.arrays[factor] for factor in quantity.operands)
        steps, after = steps[:-1], f"all_products({a}, {b}, order, {name});\n"
    step = "\n".join(steps)
    for rate in (str(rate.value) for rate in rates.values()):
        declared |= {rate: f"const real *{rate}"} if re.search(rf"\b{rate}\b", step) else {}
    return LAW.format(
        what=comment(law.__doc__),
        name=name,
        declared=", ".join(declared.values()),
        local=expansion.own_arrays(),
        step=step,
        after=after,
    )


FILES = {f"{mode}_series.h": partial(of_cases, mode, *options) for mode, options in HEADERS.items()}
FILES |= {"guard_series.h": guard_series, "motion_coordinates.h": copies, "motion_ends.h": ends}
