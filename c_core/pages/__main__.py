"""Writes the files that are derived from the pages to the project, or to a folder that is named.

`python -m c_core.pages [FOLDER]`

- `modelDescription.xml`: the description of the FMI 2.0 unit
- `c_core/derived/pages`: C of the pages that the library runs, the unit's tables, and the library's ranges
- `c_core/derived/unit`: descriptions of the FMI 3.0 unit, the units' list of source files and page of
  documentation, and the Python package's table
- `c_core/include/tdmf_slip/variables.h`, which scripts/derive_equations formats
"""

import json
import re
import sys
from pathlib import Path

from ..hybrid.c_text import c_text, wrapped_text
from ..hybrid.expressions import forget_expressions
from ..hybrid.generate import generate, seeds_of
from ..hybrid.instants import Functions
from ..hybrid.model_table import table_of
from ..hybrid.page import Page
from ..hybrid.description import build_description, description, terminals
from ..hybrid.tables import list_in_c
from ..hybrid.unit import identify
from ..hybrid.unit_tables import header, tables
from ..hybrid.unit_files import shared_sources, sources_of, write_files
from . import ClassicSlip, PlainReducedRunner, PlainRunner, ReducedRunner, Runner
from .tables import declarations, documentation_page, package_table, ranges
from .unit import runner_unit

PAGES = ClassicSlip, PlainReducedRunner, PlainRunner, ReducedRunner, Runner


PART = """\
/* {part}, a part of {whole}. */
#include "{whole_file}.h"

#include "page_part.h"

extern const tdmf_model_kind tdmf_{file}_model;
extern const tdmf_page_part tdmf_{name};

{tables}
const tdmf_page_part tdmf_{name} = {{
    .model = &tdmf_{file}_model, .parameters = parameters, .states = states, .events = events, .modes = modes,
    .copies = copies, .copy_count = {copy_count}, .excess = {excess},
}};
"""


def part_of(whole, part, name):
    """C with a name that says where parameters, states, modes and events of a page are in another page.

    The other page has them all but for modes, which are then at -1. Its modes may have further words.
    """

    def place_of_mode(key):
        return next((i for i, k in enumerate(whole.keys) if k[0] == key[0] and {*key[1]} <= {*k[1]}), -1)

    tables = list_in_c("int", "modes", map(place_of_mode, part.keys))
    for what in ("parameters", "states", "events"):
        of_whole = list(getattr(whole, what))
        tables += list_in_c("int", what, map(of_whole.index, getattr(part, what)))
    states, copies = list(whole.states), getattr(part.model, "copies", {})
    pairs = [f"{{{states.index(to)}, {states.index(of)}}}" for to, of in copies.items()]
    tables += f"static const int copies[][2] = {{{', '.join(pairs) or '{0}'}}};\n"
    functions, excess = Functions(whole.c), "NULL"
    if hasattr(part.model, "excess"):
        forget_expressions()
        body = f"    return {c_text(whole.number(part.model.excess, whole.keys[0], 'excess'), {}.get)};\n"
        excess = functions.add("excess", "answer", body, part.model.excess.__doc__)
        tables += functions.texts[0]
    return wrapped_text(PART.format(
        part=part.model.__name__, whole=whole.model.__name__, file=part.c, name=name, whole_file=whole.c,
        tables=tables, copy_count=len(copies), excess=excess))


core = Path(__file__).parents[1]
project = core.parent
folder = Path(sys.argv[1]) if len(sys.argv) > 1 else project
pages = {model: Page(model) for model in PAGES}
texts: dict[str, str] = {}
for page in pages.values():
    if page.model in (PlainRunner, PlainReducedRunner):
        page.outputs = {}  # other pages have them
    texts |= generate(page, for_unit=page.model is Runner) | seeds_of(page)
for model in (PlainRunner, PlainReducedRunner, ReducedRunner):
    texts[f"{pages[model].c}_in_runner.c"] = part_of(pages[Runner], pages[model], f"{pages[model].c}_part")
whole, plain = pages[ReducedRunner], pages[PlainReducedRunner]
texts[f"{plain.c}_in_{whole.c}.c"] = part_of(whole, plain, f"{plain.c}_in_{whole.c}")
unit = runner_unit(pages[Runner])
texts |= {"unit_page.h": header(unit), "unit_page.c": tables(unit), "ranges.c": ranges(unit)}

version_header = (core / "include/tdmf_slip/version.h").read_text("utf-8")
version = ".".join(re.findall(r"^#define TDMF_VERSION_[A-Z]+ (\d+)$", version_header, re.MULTILINE))
UNIT_FILES = r"(plain_)?runner(_motions|_in_runner)?\.[ch]|unit_page\.[ch]"
unit_files = {name: text for name, text in texts.items() if re.fullmatch(UNIT_FILES, name)}
identify(unit, unit_files, version)
texts["guid.h"] = unit_files["guid.h"]
shared = shared_sources(unit_files)
compiled = {fmi: sources_of([*unit_files, *shared], fmi) for fmi in (2, 3)}
places = {f"c_core/derived/pages/{name}" for name in unit_files}
places |= {path.relative_to(project).as_posix() for path in shared.values()}
template = (core / "pages/unit.html").read_text("utf-8")
files = {f"c_core/derived/pages/{name}": text for name, text in texts.items()} | {
    "modelDescription.xml": description(unit, 2, version, compiled[2]),
    "c_core/derived/unit/fmi3/modelDescription.xml": description(unit, 3, version, compiled[3]),
    "c_core/derived/unit/fmi3/sources/buildDescription.xml": build_description(unit, compiled[3]),
    "c_core/derived/unit/fmi3/terminalsAndIcons/terminalsAndIcons.xml": terminals(unit),
    "c_core/derived/unit/index.html": documentation_page(unit, template),
    "c_core/derived/unit/data.py": package_table(unit),
    "c_core/derived/unit/sources.txt": "\n".join([*sorted(places), ""]),
    "c_core/include/tdmf_slip/variables.h": declarations(unit),
}
for model in (ClassicSlip, Runner):
    table = json.dumps(table_of(pages[model]), indent=1)
    files[f"c_core/derived/unit/{pages[model].c}.json"] = f"{table}\n"
write_files(folder, files)
