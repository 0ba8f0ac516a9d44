"""The package's parts, each of which knows those below it only."""

import ast

import pytest
from conftest import ROOT

PACKAGE = ROOT / "scripts/tdmf_slip"
GROUND = {
    "blocks",
    "builds",
    "checks",
    "errors",
    "given",
    "record",
    "uninterrupted",
    "version",
}
BUILT = {"version"}
"""What the build writes."""
KNOWS = {
    "terminal": GROUND,
    "numerics": GROUND,
    "files": {"terminal"},
    "variables": GROUND,
    "fmu": {"variables", "terminal", "files"},
    "building": GROUND,
    "library": {"variables", "numerics", "terminal"},
    "analysis": {"library", "variables", "files", "numerics", "terminal"},
    "feedback": {"analysis", "library", "variables", "files", "terminal"},
    "fitting": {"analysis", "library", "variables", "files", "terminal"},
    "optimization": {"analysis", "library", "variables", "numerics", "terminal"},
    "proof": {"analysis", "library", "fmu", "variables", "terminal"},
    "viable_sets": {"analysis", "library", "variables", "files", "terminal"},
    "pictures": {
        *("viable_sets", "proof", "optimization", "feedback", "fitting", "analysis"),
        *("library", "fmu", "variables", "files", "terminal"),
    },
    "paper": {
        *(
            "pictures",
            "viable_sets",
            "optimization",
            "feedback",
            "fitting",
            "analysis",
            "library",
            "fmu",
            "variables",
            "files",
            "terminal",
        )
    },
    "cli": {
        *("paper", "pictures", "viable_sets", "proof", "optimization", "fitting", "analysis"),
        *("library", "building", "fmu", "variables", "files", "terminal"),
    },
}
"""By part: the parts that it may import, beside those of `GROUND`."""
READS_PAGES = {"building": {"hybrid"}, "proof": {"hybrid", "pages"}}
"""Who may import the language of pages and the runner's page. Others get their numbers from the core."""


def imported(path, text):
    """The parts that a module imports, wherever in it it does so."""
    package = path.relative_to(PACKAGE).parts[:-1]
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and node.level:
            inside = package[: len(package) - node.level + 1]
            names = [node.module] if node.module else [alias.name for alias in node.names]
            yield from (".".join((*inside, name)).split(".")[0] for name in names)
        elif isinstance(node, ast.ImportFrom | ast.Import):
            names = [node.module] if isinstance(node, ast.ImportFrom) else [a.name for a in node.names]
            assert not any(name.split(".")[0] == "tdmf_slip" for name in names), f"{path}: by its full name"


def forbidden(part, path, text):
    return set(imported(path, text)) - KNOWS[part] - READS_PAGES.get(part, set()) - GROUND - {part}


def test_every_part_has_its_place():
    folders = {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()}
    modules = {path.stem for path in PACKAGE.glob("*.py")}
    assert folders == set(KNOWS)
    assert modules == GROUND - BUILT | {"__init__", "__main__"}


def test_no_part_is_known_by_one_that_it_knows():
    """The table itself has no circle: what a part knows stands above it."""
    above = set(GROUND)
    for part, known in KNOWS.items():
        assert known <= above, part
        above.add(part)


@pytest.mark.parametrize("part", KNOWS)
def test_a_part_imports_what_is_below_it_only(part):
    modules = list((PACKAGE / part).rglob("*.py"))
    assert len(modules) >= 3
    wrong = {str(path): forbidden(part, path, path.read_text(encoding="utf-8")) for path in modules}
    assert {path: parts for path, parts in wrong.items() if parts} == {}


@pytest.mark.parametrize(
    ("part", "text"),
    [
        ("fmu", "from ..library.gait import Gait"),
        ("library", "from ..analysis import sweep"),
        ("analysis", "from ..fmu.fmu import load_fmu"),
        ("analysis", "def late():\n    from .. import cli"),
        ("files", "from ..unit import section as where"),
        ("numerics", "from ..library.gait import Gait"),
        ("analysis", "from ..pages import Runner"),
    ],
)
def test_a_wrong_arrow_is_seen(part, text):
    assert forbidden(part, PACKAGE / part / "module.py", text)


def test_the_ground_knows_itself_only():
    for name in GROUND - BUILT:
        path = PACKAGE / f"{name}.py"
        assert set(imported(path, path.read_text(encoding="utf-8"))) <= GROUND


def test_no_module_is_too_long_to_be_about_one_thing():
    modules = list(PACKAGE.rglob("*.py"))
    assert len(modules) > 60
    lengths = {str(path): len(path.read_text(encoding="utf-8").splitlines()) for path in modules}
    assert {path: length for path, length in lengths.items() if length > 500} == {}
