"""Writes the C of the pages that the library runs to c_core/derived/pages, or to a folder that is named.

`python -m c_core.pages [FOLDER]`
"""

import sys
from pathlib import Path

from ..hybrid.c_text import wrapped_text
from ..hybrid.generate import generate, seeds_of
from ..hybrid.page import Page
from ..hybrid.tables import list_in_c
from . import ClassicSlip, PlainReducedRunner, PlainRunner, ReducedRunner, Runner
from .unit import runner_unit

PAGES = ClassicSlip, PlainReducedRunner, PlainRunner, ReducedRunner, Runner


def places_in(whole, part, prefix=""):
    """A header that says where parameters, states, modes and events of a page are in another page.

    A mode of the other page may have further words. What the other page does not have is at -1.
    """

    def place_of_mode(key):
        return next((i for i, k in enumerate(whole.keys) if k[0] == key[0] and {*key[1]} <= {*k[1]}), -1)

    places = {"modes": map(place_of_mode, part.keys)}
    for what in ("parameters", "states", "events"):
        of_whole = list(getattr(whole, what))
        places[what] = [of_whole.index(n) if n in of_whole else -1 for n in getattr(part, what)]
    tables = "".join(list_in_c("int", f"{prefix}{what}_in_whole", of) for what, of in places.items())
    tables = wrapped_text(tables)
    guard = f"{part.c.upper()}_IN_{whole.c.upper()}_H"
    about = f"/* Places of what {part.model.__name__} has in the tables of {whole.model.__name__}. */\n"
    return f"{about}#ifndef {guard}\n#define {guard}\n\n{tables}\n#endif\n"


folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1] / "derived/pages"
folder.mkdir(exist_ok=True)
pages = {model: Page(model) for model in PAGES}
texts: dict[str, str] = {}
for page in pages.values():
    if page.model in (PlainRunner, PlainReducedRunner):
        page.outputs = {}  # other pages have them
    texts |= generate(page, for_unit=page.model is Runner) | seeds_of(page)
prefixes = {PlainRunner: "", ReducedRunner: "reduced_", PlainReducedRunner: "plain_reduced_"}
for model, prefix in prefixes.items():
    texts[f"{pages[model].c}_in_runner.h"] = places_in(pages[Runner], pages[model], prefix)
unit = runner_unit(pages[Runner])
texts |= {"unit_page.h": unit.header(), "unit_page.c": unit.tables()}
for name, text in texts.items():
    (folder / name).write_text(text, encoding="utf-8")
