"""The command `build`: makes the library and the FMI units of a page."""

import json
import sys
from pathlib import Path

import click

from ..building.build import build
from ..building.compilers import TARGETS
from ..builds import TABLE
from .options import JSON_OPTION, Command, json_text


@click.command("build", cls=Command)
@click.argument("page", type=click.Path(path_type=Path))
@click.option(
    "--platform",
    type=click.Choice(list(TARGETS)),
    help="Another platform, for which Zig compiles; by default this machine's.",
)
@click.option("--unit/--no-unit", default=True, help="Make FMI units, too.")
@click.option(
    "--output",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Folder of the result; by default `build` beside the page.",
)
@JSON_OPTION
def build_command(
    page: Path, platform: str | None, unit: bool, output: Path | None, as_json_object: bool
) -> None:
    """Make a library and FMI units of a page: of a folder with page.py, or of a file in Python.

    Python loads the result by tdmf_slip.load_model.
    """
    print(
        "tdmf-slip: deriving and compiling, for a page of the runner's size about a minute", file=sys.stderr
    )
    folder = build(page, output, platform=platform, unit=unit)
    files = sorted(folder.iterdir())
    if as_json_object:
        table = json.loads((folder / TABLE).read_text(encoding="utf-8"))
        known = {name: table[name] for name in ("name", "version", "id", "libraries")}
        print(json_text({**known, "files": [str(path) for path in files]}))
    else:
        print("\n".join(map(str, files)))
