"""Headers of the motions, from the table of these: series, guards as series, where motions begin and lead."""

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace as Record
from typing import Any

from .. import motions
from ..motions import STRUCTS
from .c import header, struct
from .expressions import parameters
from .law_series import law_series
from .motion import Family
from .values import Function, members

FAMILIES = {
    name: Family(name, **(given | {"constants": members(given["constants"])}))
    for name, given in motions.MOTIONS.items()
}


def of_cases(mode: str, name: str, cases: list[str]) -> str:
    """Write a header of some cases; without a torque variations are those of a leg that turns."""
    family = FAMILIES[name]
    parts = [family.motion(case).source() for case in cases]
    parts += [family.motion(case).variation() for case in cases if family.cases[case].get("has_torque", True)]
    is_first = mode == name
    include = "series_products.h" if is_first else f"{name}_series.h"
    parts = [family.structs(), *parts] if is_first else parts
    return header(f"{mode}_series", f"{name}.py", f'#include "{include}"\n', *parts)


def copies() -> str:
    """Write copies between what motions start with and the coordinates of the model."""
    parts = []
    for name, family in FAMILIES.items():

        def same(at: Any, family: Family = family) -> Record:
            """What a motion starts with, of the model's coordinates, or back."""
            return Record(**{name: getattr(at, name) for name in family.start})

        model, start = motions.COORDINATES[name], f"{name}_start"
        types = {"at": f"const {start} *", "written": f"{model} *"}
        parts += [
            Function(start, f"{name}_start_of", {"at": f"const {model} *"}, same, varied=False).c(),
            Function("void", f"set_{name}", types, same, varied=False).c(),
        ]
    includes = "".join(f'#include "{name}.h"\n' for name in ("coordinate_laws", "motion_series"))
    return header("motion_coordinates", "flight.py and ground.py", includes, *parts)


def ends() -> str:
    """Write where motions lead."""
    includes = '#include "motion_series.h"\n#include "step_sums.h"\n'
    ends = [family.end() for family in FAMILIES.values()]
    return header("motion_ends", "flight.py and ground.py", includes, *ends)


def guard_series() -> str:
    """Write guards that are made of series of the motion, and what they are made of."""
    given = [struct(law.__doc__, name, members(law), "real") for name, law in STRUCTS.values()]
    laws = [law_series(*told) for told in motions.GUARDS]
    numbers = [of_numbers(law).c() for law in motions.OF_NUMBERS]
    include = '#include "series_products.h"\n'
    pages = "ground.py, flight.py, friction.py and hip.py"
    return header("guard_series", pages, include, *given, *laws, *numbers)


def of_numbers(law: Callable[..., Any]) -> Function:
    """Give the function of a law of numbers as lanes have them."""
    types = {n: f"const {STRUCTS[n][0]} *" if n in STRUCTS else "real" for n in parameters(law)}
    return Function("real", law.__name__, types, law, varied=False, number="real")


FILES = {f"{mode}_series.h": partial(of_cases, mode, *told) for mode, told in motions.HEADERS.items()}
FILES |= {"guard_series.h": guard_series, "motion_coordinates.h": copies, "motion_ends.h": ends}
