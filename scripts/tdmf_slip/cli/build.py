"""The command `build`: makes the library and the FMI units of a page."""

import json
import sys
from pathlib import Path

import click

from ..building.build import build
from ..building.compilers import TARGETS
from ..building.sources import page_file
from ..builds import TABLE
from .command import Answer, command, option

PATH = click.Path(path_type=Path)


@command(
    "build",
    click.argument("page", type=PATH),
    option("--platform", of=build, kind=click.Choice(list(TARGETS))),
    option("--unit/--no-unit", "unit", of=build),
    option("--output", "folder", of=build, kind=PATH, metavar="FOLDER"),
    runner=False,
)
def build_command(page: Path, folder: Path | None, platform: str | None, unit: bool) -> Answer:
    """Build a C library and FMI units from a page: a folder with page.py, or a Python file.

    In Python, tdmf_slip.load_model loads the result.
    """
    page_file(page)  # refuses a missing page before anything is announced
    print("tdmf-slip: deriving and compiling; the runner's own page takes about a minute", file=sys.stderr)
    folder = build(page, folder, platform=platform, unit=unit)
    files = [str(path) for path in sorted(folder.iterdir())]
    table = json.loads((folder / TABLE).read_text(encoding="utf-8"))
    known = {name: table[name] for name in ("name", "version", "id", "libraries")}
    return Answer({**known, "files": files}, "\n".join(files))
