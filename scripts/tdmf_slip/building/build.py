"""Building a page: the C that is derived from it, compiled as a shared library, with the model's table."""

import contextlib
import hashlib
import json
import os
import shutil
import tempfile
import threading
import warnings
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ..builds import FOLDER, TABLE
from ..checks import path_of
from ..errors import InputError, Note, RunError, reason
from ..version import __version__
from .compilers import Compiler, compiler_for
from .sources import page_file, page_in

PACKAGE = Path(__file__).parents[1]
KERNEL = PACKAGE / "hybrid" / "kernel", PACKAGE / "kernel"
"""Folders of the driver and of what it includes."""
HEADERS, MAPS = PACKAGE / "native", (PACKAGE / "gait", PACKAGE / "ensemble")
"""The public headers, and folders of the sources of return maps of pages, and of many runs by them."""
LIBRARY_FLAGS = ("-DTDMF_BUILDS_SHARED_LIBRARY", "-Wno-psabi")
"""Flags of the compiler beside those that FMI units have, too."""
LANES = "batch_lanes.c"
"""The file that is compiled once for each number of lanes, beside the motions."""
_one_at_a_time = threading.Lock()
"""The generator keeps expressions of one page."""


def build(
    page: Any,
    folder: str | os.PathLike[str] | None = None,
    *,
    platform: str | None = None,
    unit: bool = True,
) -> Path:
    """Derive a page's equations to C, and compile them: a library that `load_model` loads, and FMI units.

    Parameters
    ----------
    page : str, Path, or subclass of tdmf_slip.hybrid.Model
        A folder with `page.py`, a file in Python, or the class itself.
    folder : str or Path, optional
        Where the result goes. By default the folder `build` beside the page's file.
    platform : str, optional
        Another platform for which Zig compiles; by default this machine's.

        Libraries and units for other platforms that are in the folder stay if they are of the same page.
        FMI 2.0 has one name for each system: its unit has libraries for x86_64, and on macOS for the
        processor built last.
    unit : bool, default True
        Make FMI units, too.

    Returns
    -------
    Path
        The folder, with the model's table `model.json`, a library for each platform, and for a page MyRunner
        its units `MyRunner.fmu` of FMI 2.0 and `MyRunner_FMI3.fmu`, with sources inside, and the
        `modelDescription.xml` of the former.

    Raises
    ------
    InputError
        The page has an error, or there is no compiler; the message says where, and what is allowed.

    Examples
    --------
    >>> import tdmf_slip
    >>> folder = tdmf_slip.new("my_ball", start="scratch")
    >>> model = tdmf_slip.load_model(tdmf_slip.build(folder))
    >>> print(model.coordinates)
    ('height',)
    """
    if isinstance(page, type):
        model, beside = page, None
    else:
        path = page_file(page)
        model, beside = page_in(path), path.parent / FOLDER
    target = beside if folder is None else path_of(folder, "folder", "the path of a folder")
    if target is None:
        raise InputError("build: a class without a folder; allowed: build(page, folder)")
    compiler = compiler_for(platform)
    table, files = derived(model)
    with new_folder(target) as made:
        _compile(table, files, compiler, made)
        known = _libraries_of_other_platforms(target, table["id"], made)
        table["libraries"] = {**known, compiler.platform: _library_name(table, compiler)}
        if unit:
            _make_units(model, compiler, made, target if known else None)
        (made / TABLE).write_text(json.dumps(table, indent=1), encoding="utf-8")
    return target


def derived(model: Any) -> tuple[dict[str, Any], dict[str, str]]:
    """The table of a page and its C by file."""
    from ..hybrid.errors import PageError
    from ..hybrid.generate import generate, seeds_of
    from ..hybrid.instants import Functions
    from ..hybrid.model_table import table_of
    from ..hybrid.page import Page
    from ..hybrid.unit_tables import requirements_in_c

    with _one_at_a_time:
        try:
            page: Any = Page(model)
            files: dict[str, str] = generate(page) | seeds_of(page)
            table: dict[str, Any] = table_of(page)
            functions: Any = Functions(page.c)
            requirements = list(requirements_in_c(page, functions).values())
        except PageError as problem:
            raise InputError(str(problem)) from None
    _note(page.unreached, "`{}` is a mode to which no event leads")
    _note(page.uncalled, "nothing on the page calls `{}`")
    text = repr((__version__, sorted(files.items()), table, functions.texts, _digest_of_kernel()))
    table |= {"version": __version__, "id": hashlib.sha256(text.encode()).hexdigest()[:16]}
    files[f"{table['c_name']}_list.c"] = _list_in_c(table, functions.texts, requirements)
    return table, files


def _note(functions: Mapping[str, Any], text: str) -> None:
    """Say what has no effect on a page of a user; the package's pages leave some functions to subclasses."""
    for name, function in functions.items():
        code = function.__code__
        if not Path(code.co_filename).is_relative_to(PACKAGE / "pages"):
            place = f"{code.co_filename}:{code.co_firstlineno}"
            warnings.warn(f"{place}: {text.format(name)}", Note, stacklevel=3)


def _make_units(model: Any, compiler: Compiler, made: Path, earlier: Path | None) -> None:
    """Make the FMI units of a page, with what earlier units have for other platforms."""
    from ..hybrid.errors import PageError
    from ..hybrid.unit_files import build_units

    with _one_at_a_time, tempfile.TemporaryDirectory(prefix="tdmf_slip_") as temporary:
        try:
            built: list[Path] = build_units(
                model, temporary, __version__, compiler.command, of=compiler.platform, earlier=earlier
            )
        except PageError as problem:
            raise InputError(f"{problem} (without FMI units: unit=False, --no-unit)") from None
        except RuntimeError as problem:
            raise RunError(str(problem)) from None
        for file in (*built, Path(temporary) / "fmi2" / "modelDescription.xml"):
            shutil.copy2(file, made / file.name)


def _digest_of_kernel() -> str:
    """Digest of the C that every page is compiled with."""
    digest = hashlib.sha256()
    for folder in (*KERNEL, HEADERS / "tdmf_slip", *MAPS):
        for file in sorted(folder.glob("*.[ch]")):
            digest.update(file.read_bytes())
    return digest.hexdigest()


def _list_in_c(table: Mapping[str, Any], functions: Sequence[str], requirements: Sequence[str]) -> str:
    """C that names the model of the library and what its starts require, with the identity of the build."""
    name, texts = table["c_name"], "\n".join(functions)
    listed = ", ".join(requirements) or "NULL"
    return f"""/* The model of this library. */
#include "member.h"
#include "page_map.h"
#include "{name}.h"

{texts}
static tdmf_answer *const requirements[] = {{{listed}}};
const tdmf_page_entry tdmf_pages[] = {{
    {{"{name}", {{.model = &tdmf_{name}_model}}, NULL, requirements, {len(requirements)}}}}};
const int tdmf_page_count = 1;
const char *const tdmf_build_identity = "{table["id"]}";
const tdmf_member_kind *const tdmf_runner_kind = NULL;
tdmf_model_kind tdmf_model_in_lanes(const tdmf_model_kind *model) {{
    return *model;
}}
"""


def _sources(
    table: Mapping[str, Any], folder: Path, compiler: Compiler
) -> Iterator[tuple[Path, Sequence[str]]]:
    """All files to compile, each with its flags, those that take longest first."""
    name, lanes = table["c_name"], compiler.lanes
    motions = folder / f"{name}_motions.c"
    has = *(f"-D{macro}" for macro, _ in lanes.values()), "-DTDMF_HAS_SEED_LANES"
    for width, (_, flags) in sorted(lanes.items(), reverse=True):
        wide = ("-O2", f"-DTDMF_LANES={width}", *flags)
        yield motions, wide
        yield KERNEL[0] / LANES, wide
    scalar = ("-O2", "-fno-tree-vectorize", *has)
    yield motions, scalar
    yield folder / f"{name}_seeds.c", scalar
    yield folder / f"{name}.c", ("-O1", *has)
    yield folder / f"{name}_list.c", has
    for file in sorted(file for of in (*KERNEL, *MAPS) for file in of.glob("*.c")):
        if file.name != LANES:
            yield file, scalar


def _library_name(table: Mapping[str, Any], compiler: Compiler) -> str:
    """The library's file. Another build has another name, so that a loaded library is never overwritten."""
    return f"{table['c_name']}-{compiler.platform}-{table['id']}{compiler.suffix}"


def _compile(table: Mapping[str, Any], files: Mapping[str, str], compiler: Compiler, made: Path) -> None:
    """Compile the C of a page into a library in a folder."""
    from ..hybrid.unit_files import FLAGS

    with tempfile.TemporaryDirectory(prefix="tdmf_slip_") as temporary:
        folder = Path(temporary)
        for name, text in files.items():
            (folder / name).write_text(text, encoding="utf-8")
        includes = [f"-I{path}" for path in (folder, *KERNEL, HEADERS, *MAPS)]
        sources = list(_sources(table, folder, compiler))
        objects = [folder / f"{number}.o" for number in range(len(sources))]

        def compiled(number: int) -> None:
            path, flags = sources[number]
            compiler.run([*FLAGS, *LIBRARY_FLAGS, *flags, *includes, "-c", path, "-o", objects[number]])

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(compiled, range(len(sources))))
        threads = () if compiler.platform.endswith("windows") else ("-pthread", "-lm")
        library = folder / _library_name(table, compiler)
        compiler.run(["-shared", *objects, *threads, "-o", library])
        shutil.copy2(library, made / library.name)  # without what linkers for Windows write beside it


def _libraries_of_other_platforms(target: Path, id: str, made: Path) -> dict[str, str]:
    """Take over libraries that the same page was compiled to for other platforms."""
    try:
        before = json.loads((target / TABLE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    if before.get("id") != id:
        return {}
    for name in before["libraries"].values():
        if not (made / name).exists():
            shutil.copy2(target / name, made / name)
    return dict(before["libraries"])


@contextmanager
def new_folder(target: Path) -> Iterator[Path]:
    """A folder whose files go to the target in the end; where something goes wrong, nothing changes there.

    The table goes last: until then the libraries that it names are there. Files are replaced, never written
    into: a process that loads a library meanwhile has the earlier one, whole.
    """
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        if target.exists() and not (target / TABLE).exists() and any(target.iterdir()):
            raise InputError(
                f"folder {target}: has other files in it; allowed: a new folder, or that of an earlier build"
            )
        made = Path(tempfile.mkdtemp(prefix=f".{target.name}-", dir=target.parent))
    except OSError as problem:
        raise InputError(f"folder {target}: {reason(problem)}") from None
    try:
        yield made
        names = sorted((file.name for file in made.iterdir()), key=lambda name: name == TABLE)
        target.mkdir(exist_ok=True)
        for name in names:
            (made / name).replace(target / name)
        for file in target.iterdir():
            if file.name not in names:
                with contextlib.suppress(OSError):
                    file.unlink()
    except OSError as problem:
        raise InputError(f"folder {target}: {reason(problem)}") from None
    finally:
        shutil.rmtree(made, ignore_errors=True)
