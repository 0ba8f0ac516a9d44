"""A page for each sub-package, written before Sphinx reads its sources, and a check for missing docstrings.

Public are: every module outside the command line, and in it every name without an underscore.
"""

import ast
import importlib.util
import inspect
from collections.abc import Iterator
from pathlib import Path

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

PACKAGE = "tdmf_slip"
WITHOUT_PAGE = (
    "cli",
    "__main__",
    "hybrid",
    "library.c_structs",
    "library.structs",
    "pages",
)
"""Modules without a generated page. The command line, the C structs and the language of pages have pages of
their own."""


def modules(folder: Path) -> dict[str, Path]:
    """Files of the public modules below a package's folder, by name within it."""
    found = {}
    for path in sorted(folder.rglob("*.py")):
        name = ".".join(path.relative_to(folder).with_suffix("").parts).removesuffix("__init__").rstrip(".")
        if not any(name == other or name.startswith(f"{other}.") for other in WITHOUT_PAGE):
            found[name] = path
    return found


def undocumented(path: Path) -> Iterator[str]:
    """Public names of a module that no docstring tells of, the module itself among them."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    if not ast.get_docstring(tree):
        yield path.stem
    yield from _undocumented_in(tree, "")


def _undocumented_in(node: ast.Module | ast.ClassDef, outer: str) -> Iterator[str]:
    for item, following in zip(node.body, [*node.body[1:], None], strict=True):
        if isinstance(item, ast.FunctionDef | ast.ClassDef) and not item.name.startswith("_"):
            if not ast.get_docstring(item) and not _is_overload(item):
                yield outer + item.name
            if isinstance(item, ast.ClassDef):
                yield from _undocumented_in(item, f"{outer}{item.name}.")
        elif outer and isinstance(item, ast.AnnAssign) and not _is_docstring(following):
            name = ast.unparse(item.target)
            if not name.startswith("_"):
                yield outer + name


def _is_overload(item: ast.FunctionDef | ast.ClassDef) -> bool:
    return any("overload" in ast.unparse(decorator) for decorator in item.decorator_list)


def _is_docstring(item: ast.stmt | None) -> bool:
    return (
        isinstance(item, ast.Expr)
        and isinstance(item.value, ast.Constant)
        and isinstance(item.value.value, str)
    )


def check(folder: Path) -> None:
    """Refuse a package in which a public name is not told of."""
    missing = [f"{name}: {untold}" for name, path in modules(folder).items() for untold in undocumented(path)]
    if missing:
        raise ExtensionError(f"public names without documentation: {', '.join(missing)}")


def write_pages(app: Sphinx) -> None:
    """A page for each sub-package, in the folder that git ignores."""
    spec = importlib.util.find_spec(PACKAGE)
    assert spec is not None and spec.origin is not None
    folder = Path(spec.origin).parent
    check(folder)
    target = Path(app.srcdir) / "reference/python/generated"
    target.mkdir(parents=True, exist_ok=True)
    parts: dict[str, list[str]] = {}
    for name in modules(folder):
        part = name.partition(".")[0]
        is_package = (folder / part / "__init__.py").exists()
        parts.setdefault(part if is_package else "", []).append(name)
    for part, names in parts.items():
        title = f"{PACKAGE}.{part}" if part else f"{PACKAGE}: errors and values"
        lines = [title, "=" * len(title), ""]
        for name in names:
            lines += _module(name, part)
        _write_if_changed(target / f"{part or 'ground'}.rst", "\n".join(lines))
    for page in target.glob("*.rst"):
        if page.stem not in parts and page.stem != "ground":
            page.unlink()  # its sub-package is gone


def _module(name: str, part: str) -> list[str]:
    full = f"{PACKAGE}.{name}".rstrip(".")
    if name == part:
        return [f".. automodule:: {full}", ""]
    return [full, "-" * len(full), "", f".. automodule:: {full}", "   :members:", ""]


def _write_if_changed(path: Path, text: str) -> None:
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


FIRST = (
    "find_gait",
    "simulate",
    "trajectory",
    "plot",
    "sweep",
    "gait_at",
    "compare",
    "continue_branch",
    "continue_curves",
    "basin",
    "viability",
    "strides_to_fall",
    "rare_falls",
    "stride_map",
    "simulate_many",
    "controllability",
    "dead_beat",
    "lqr",
    "place_poles",
    "apex_covariance",
    "optimize",
    "pareto_front",
    "fit",
    "prove",
)
"""Functions in the order in which the guides introduce them; all others follow by name."""


def _kind(thing: object) -> str:
    if not inspect.isclass(thing):
        return "Functions"
    return "Errors" if issubclass(thing, Exception) else "Classes"


def _as_introduced(name: str) -> tuple[int, str]:
    return (FIRST.index(name) if name in FIRST else len(FIRST), name)


class PythonTop(SphinxDirective):
    """The directive `python-top`: names of the package itself, each with its first sentence and a link."""

    def run(self) -> list[nodes.Node]:
        """Write functions, classes and errors, each in the order in which a user meets them."""
        package = importlib.import_module(PACKAGE)
        names = sorted((name for name in package.__all__ if not name.startswith("_")), key=_as_introduced)
        lines = StringList(["````{eval-rst}"], PACKAGE)  # pages are MyST
        for kind in ("Functions", "Classes", "Errors"):
            lines.extend(StringList([f".. rubric:: {kind}", ""], PACKAGE))
            for name in names:
                thing = getattr(package, name)
                if _kind(thing) == kind:
                    summary = (inspect.getdoc(thing) or "").partition("\n\n")[0].replace("\n", " ")
                    lines.append(f":py:obj:`~{thing.__module__}.{name}`", PACKAGE)
                    lines.append(f"   {summary}", PACKAGE)
            lines.append("", PACKAGE)
        lines.append("````", PACKAGE)
        around = nodes.container()
        self.state.nested_parse(lines, self.content_offset, around)
        return around.children


def skip_foreign(
    app: Sphinx, what: str, name: str, thing: object, skip: bool, options: object
) -> bool | None:
    """Leave out methods of other packages: Matplotlib adds `set` to each class of artists."""
    return True if inspect.isfunction(thing) and not thing.__module__.startswith(PACKAGE) else None


def setup(app: Sphinx) -> dict[str, bool]:
    """Let the pages be written before the sources are read."""
    app.add_directive("python-top", PythonTop)
    app.connect("autodoc-skip-member", skip_foreign)
    app.connect("builder-inited", write_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
