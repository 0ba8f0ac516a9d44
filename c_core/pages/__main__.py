"""Writes the C of the pages that the library runs to c_core/derived/pages, or to a folder that is named.

`python -m c_core.pages [FOLDER]`
"""

import sys
from pathlib import Path

from ..hybrid import derive
from .classic import ClassicSlip
from .reduced import ReducedRunner
from .runner import PlainRunner, Runner

PAGES = ClassicSlip, PlainRunner, ReducedRunner, Runner

folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1] / "derived/pages"
folder.mkdir(exist_ok=True)
for page in PAGES:
    for name, text in derive(page).items():
        (folder / name).write_text(text, encoding="utf-8")
