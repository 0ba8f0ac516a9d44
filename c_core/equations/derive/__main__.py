"""Writes c_core/derived, or the folder that is named: `python -m equations.derive [FOLDER]`, in c_core."""

import sys
from pathlib import Path

from . import events, model

FILES = model.FILES | events.FILES

folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[2] / "derived"
folder.mkdir(exist_ok=True)
for name, write in FILES.items():
    (folder / name).write_text(write(), encoding="utf-8")
