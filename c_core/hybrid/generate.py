"""C99 of a page: a header, the motions of its modes, and functions of an instant, such as decisions.

Each mode that a run can reach is traced on its own, with plain Python values for its words. Modes share a
function of C if its text is equal in them.
"""

import json
import re

from .c_text import comment, lines_of, number_text, wrapped_text
from .errors import page_error
from .expressions import forget_expressions, lift
from .instants import Functions, Instants, c_name
from .limits import FILES
from .motions import Motion
from .page import Page
from .quantities import range_of
from .tables import enumeration, list_in_c, lists_in_c, row_in_c, rows_in_c

SEEDS = """\
/* First variations of {name} along two seeds at once, by motions of two lanes. */
#define TDMF_LANES 2
#define TDMF_LANES_ARE_SEEDS

#include "{page}_motions.c"

#include "seeds.h"

const tdmf_seed_kind tdmf_{page}_seeds = {{
    TDMF_OF_WIDTH(tdmf_{page}_motions), fill_seed_lanes, vary_seed_lanes, read_seed_lane}};
"""
TOP = "/* Derived from the page {name}: edit the page, not this. */\n"


def struct_of(page, kind, quantities):
    """A struct of quantities, with the unit and meaning of each."""
    lines = []
    for name, q in quantities.items():
        about = f"{q.unit}: {q.meaning}" if q.meaning else q.unit
        lines.append(f"real {page.c_names[name]}; /* {about.replace('*/', '* /')} */")
    return f"typedef struct {{\n{lines_of(lines or ['real none;'])}}} {page.c}_{kind};\n"


def motion_row(page, motion):
    """The tables of a motion, and its row in the table of motions."""
    name, states = motion.name, list(page.states)
    polynomials = [f"guard_{name}_{n}" for n in [*motion.watched, *motion.observed]] or ["NULL"]
    tables = list_in_c("tdmf_polynomial", f"polynomials_{name}", polynomials)
    varied = [f"d_observed_{name}_{n}" for n in motion.observed] or ["NULL"]
    tables += list_in_c("tdmf_vary_polynomial", f"vary_observed_{name}", varied)
    moving = [states.index(n) for n in motion.moving]
    row = {"moving_count": len(moving), "extra_count": len(motion.rates) - len(moving)}
    row |= {"series_count": len(motion.series), "constant_count": len(motion.constants)}
    row |= {"judged_count": len(motion.judged), "divisor_count": len(motion.divisors)}
    lists = ("moving", "degrees", "judged", "divided", "divisors", "integrals", "factors")
    numbers = {f"{what}_{name}": moving if what == "moving" else getattr(motion, what) for what in lists}
    tables += lists_in_c("int", numbers)
    row |= {what: f"{what}_{name}" for what in (*lists, "polynomials", "vary_observed")}
    row |= {"expand": f"expand_{name}", "vary": f"vary_{name}"}
    return tables, row_in_c(row | {"bounds": f"bounds_{name}" if motion.has_bounds else "NULL"})


def seeds_of(page):
    """The file that varies two seeds of a page at once, for a library that has the C of `generate`, too."""
    text = SEEDS.format(name=page.model.__name__, page=page.c)
    return {f"{page.c}_seeds.c": wrapped_text(text)}


def derive(model):
    """The C of a page by file: a header, the motions of its modes, and what happens at an instant."""
    return generate(Page(model))


def generate(page, for_unit=True):
    """The C of a page that has been read, by file. Only a unit needs the rates of the world's states."""
    page.c = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", page.model.__name__).lower()
    page.c += "_" * (page.c in FILES)
    functions, names = Functions(page.c), [c_name(key) for key in page.keys]
    for i, (mode, _) in enumerate(page.keys):
        if names[i] in names[:i]:
            text = f"has the name `{names[i]}` with its words, which another mode has; rename one of them"
            raise page_error(page.modes[mode], mode, text)
    instants, top = Instants(page, functions, for_unit), TOP.format(name=page.model.__name__)
    header = [
        f'{top}#ifndef {page.c.upper()}_H\n#define {page.c.upper()}_H\n\n#include "driver.h"\n',
        enumeration("MODE", names) + enumeration("EVENT", page.events) + enumeration("OUTPUT", page.outputs),
        enumeration("TABLE", page.tables)
        + "".join(enumeration(f"COLUMN_{name}", of.columns) for name, of in page.tables.items()),
        struct_of(page, "parameters", page.parameters),
        struct_of(page, "states", page.states),
    ]
    motions, motion_rows, motion_tables, mode_rows, tables = [f'{top}#include "{page.c}.h"\n'], "", "", "", ""
    series_count = constant_count = 1
    for key, name in zip(page.keys, names, strict=True):
        motion = Motion(page, key, name)
        header.append(motion.struct("constants", motion.constants))
        motions.append(f"/* ---- {name} */\n\n{comment(motion.function.__doc__)}{motion.in_c()}")
        for_mode, mode_row = instants.mode_row(key, motion)
        for_motion, row = motion_row(page, motion)
        tables, mode_rows = tables + for_mode, mode_rows + mode_row
        motion_tables, motion_rows = motion_tables + for_motion, motion_rows + row
        series_count = max(series_count, len(motion.series))
        constant_count = max(constant_count, len(motion.constants))
    table, of_width = f"TDMF_OF_WIDTH(tdmf_{page.c}_motions)", f"tdmf_{page.c}_motions_of"
    motions.append(
        f"{motion_tables}\nconst tdmf_motion_kind {table}[] = {{\n{motion_rows}}};\n\n#ifdef TDMF_LANES\n"
        f"const void *TDMF_OF_WIDTH({of_width})(void) {{\n    return {table};\n}}\n#endif\n"
    )
    model = f"const tdmf_model_kind tdmf_{page.c}_model"
    header.append(
        f"extern const tdmf_motion_kind {table}[];\n"
        f"tdmf_motions_of_width {of_width}_2, {of_width}_4, {of_width}_8;\n"
        f"extern const tdmf_seed_kind tdmf_{page.c}_seeds;\nextern {model};\n\n#endif\n"
    )
    (set_tables, set_rows), (section_tables, section_rows) = instants.sets(), instants.section_rows()
    row = {"modes": "modes", "sets": "sets", "set_count": len(set_rows), "sections": "sections"}
    row["scales"] = instants.scales()
    row |= {"series_count": series_count, "constant_count": constant_count}
    lanes = zip(("TWO", "FOUR", "EIGHT"), (2, 4, 8), strict=True)
    row["lanes"] = f"{{{', '.join(f'TDMF_{name}_LANES({of_width}_{width})' for name, width in lanes)}}}"
    row["seeds"] = f"TDMF_FOR_SEEDS(tdmf_{page.c}_seeds)"
    lists = ""
    named = {"state": page.states, "parameter": page.parameters, "event": page.events}
    named |= {"output": page.outputs, "table": page.tables, "section": page.sections}
    for what, of in ({"mode": names} | named).items():
        lists += list_in_c("char *const", f"{what}_names", map(json.dumps, of))
        row |= {f"{what}_count": len(of), f"{what}_names": f"{what}_names"}
    for what in ("state", "parameter"):
        defaults = [number_text(lift(q.value).value) for q in named[what].values()]
        lists += list_in_c("double", f"{what}_defaults", defaults)
        row[f"{what}_defaults"] = f"{what}_defaults"
    for i, end in enumerate(("least", "most")):
        bounds = [number_text(range_of(q)[i]) for q in page.parameters.values()]
        lists += list_in_c("double", f"parameter_{end}", bounds)
        row[f"parameter_{end}"] = f"parameter_{end}"
    instant = [
        f'{top}#include "{page.c}.h"\n',
        *functions.texts,
        tables + set_tables + section_tables,
        f"static const tdmf_mode_kind modes[] = {{\n{mode_rows}}};\n",
        rows_in_c("set", "sets", set_rows, "index") + rows_in_c("section", "sections", section_rows, "event"),
        lists,
        f"{model} = {{\n{lines_of(f'.{n} = {v},' for n, v in row.items())}}};\n",
    ]
    forget_expressions()
    texts = {f"{page.c}.h": header, f"{page.c}_motions.c": motions, f"{page.c}.c": instant}
    return {name: wrapped_text("\n".join(parts)) for name, parts in texts.items()}
