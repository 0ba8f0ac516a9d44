"""Writes the C of the pages that the library runs to c_core/derived/pages, or to a folder that is named.

`python -m c_core.pages [FOLDER]`
"""

import sys
from pathlib import Path

from ..hybrid.generate import generate
from ..hybrid.instants import c_name
from ..hybrid.page import Page
from ..hybrid.tables import list_in_c
from .classic import ClassicSlip
from .reduced import ReducedRunner
from .runner import PlainRunner, Runner

PAGES = ClassicSlip, PlainRunner, ReducedRunner, Runner


def places_in(whole, part):
    """A header that says where parameters, states, modes and events of a page are in another page."""
    names = {
        "parameters": lambda page: list(page.parameters),
        "states": lambda page: list(page.states),
        "modes": lambda page: [c_name(key) for key in page.keys],
        "events": lambda page: list(page.events),
    }
    tables = "".join(
        list_in_c("int", f"{what}_in_whole", map(names_of(whole).index, names_of(part)))
        for what, names_of in names.items()
    )
    guard = f"{part.c.upper()}_IN_{whole.c.upper()}_H"
    about = f"/* Places of what {part.model.__name__} has in the tables of {whole.model.__name__}. */\n"
    return f"{about}#ifndef {guard}\n#define {guard}\n\n{tables}\n#endif\n"


folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1] / "derived/pages"
folder.mkdir(exist_ok=True)
pages = {model: Page(model) for model in PAGES}
texts: dict[str, str] = {}
for page in pages.values():
    texts |= generate(page)
texts["plain_runner_in_runner.h"] = places_in(pages[Runner], pages[PlainRunner])
for name, text in texts.items():
    (folder / name).write_text(text, encoding="utf-8")
