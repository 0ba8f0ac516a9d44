"""Parts of the package are layers: each imports only the parts before it."""

import ast
import re

from conftest import ROOT

PACKAGE = ROOT / "scripts/tdmf_slip"
GROUND = {"blocks", "builds", "checks", "errors", "given", "record", "uninterrupted", "version"}
"""Modules that every part may import; they import only each other. The build writes `version`."""
PARTS = (
    "terminal", "numerics", "files", "variables", "fmu", "building", "library", "analysis", "feedback",
    "fitting", "optimization", "proof", "viable_sets", "pictures", "paper", "cli",
)  # fmt: skip
"""The parts in order: a part may import those before it."""
KNOWN_TO = {
    "fmu": {"proof", "pictures", "paper", "cli"},
    "building": {"cli"},
    "hybrid": {"building", "proof"},
    "pages": {"proof"},
}
"""Parts, and the language and the pages from `c_core`, that only some parts may import."""


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
    before = {*GROUND, *PARTS[: PARTS.index(part) + 1], "hybrid", "pages"}
    hidden = {name for name, parts in KNOWN_TO.items() if part not in {*parts, name}}
    return set(imported(path, text)) - (before - hidden)


def test_every_part_has_its_place():
    assert {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()} == set(PARTS)
    assert {path.stem for path in PACKAGE.glob("*.py")} == GROUND - {"version"} | {"__init__", "__main__"}


def test_parts_import_only_what_is_before_them():
    modules = [(part, path) for part in PARTS for path in (PACKAGE / part).rglob("*.py")]
    assert len(modules) > 60
    wrong = {str(path): forbidden(part, path, path.read_text(encoding="utf-8")) for part, path in modules}
    assert {path: parts for path, parts in wrong.items() if parts} == {}
    for name in GROUND - {"version"}:
        path = PACKAGE / f"{name}.py"
        assert set(imported(path, path.read_text(encoding="utf-8"))) <= GROUND


def test_guides_and_examples_import_public_names_only():
    """They take names from `tdmf_slip`, `tdmf_slip.hybrid` or `tdmf_slip.pages`, and from no module below."""
    guides = [
        path for folder in ("guides", "reference") for path in (ROOT / "documentation" / folder).glob("*.md")
    ]
    examples = list((ROOT / "examples").rglob("*.py"))
    below = re.compile(r"^ *(?:from|import) tdmf_slip\.(?!(?:hybrid|pages) import\b).*", re.MULTILINE)
    found = {path.name: below.findall(path.read_text(encoding="utf-8")) for path in guides + examples}
    assert len(guides) > 40 and len(examples) > 15
    assert {name: lines for name, lines in found.items() if lines} == {}


def test_no_module_is_longer_than_500_lines():
    lengths = {
        str(path): len(path.read_text(encoding="utf-8").splitlines()) for path in PACKAGE.rglob("*.py")
    }
    assert {path: length for path, length in lengths.items() if length > 500} == {}
