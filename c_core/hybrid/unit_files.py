"""Writes a page's unit to a folder, compiles it, and packs it: FMUs of FMI 2.0 and 3.0 with their sources."""

import importlib.util
import os
import platform
import re
import shutil
import subprocess
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .description import build_description, description
from .limits import C_CORE, UNIT
from .unit import unit_of

KERNEL = C_CORE / "hybrid" / "kernel"
FOLDERS = UNIT, KERNEL, C_CORE / "kernel"
DRIVER = (
    "driver.c",
    "no_page_cvode.c",
    "observed.c",
    "page_exchange.c",
    "page_instant.c",
    "page_part.c",
    "run_state.c",
)
FLAGS = ("-std=c99", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-fvisibility=hidden")
MOTIONS = ("-O2", "-fno-tree-vectorize")
SYSTEMS = {"linux": ("linux64", ".so"), "darwin": ("darwin64", ".dylib"), "windows": ("win64", ".dll")}
"""Names of systems in FMI 2.0, and suffixes of their shared libraries, by their names in FMI 3.0."""
PROCESSORS = {"amd64": "x86_64", "arm64": "aarch64"}


DECLARED = r"^(?!static|typedef|KERNEL|return)[a-z][^;{}()=]*?\b(\w+)(?:\([^;{}]*\)|(?:\[\])?);"
"""A declaration of a function or a table in a header."""
NOT_CODE = r"/\*.*?\*/|#[^\n]*(\\\n[^\n]*)*"
NAMES = """\
/* Gives every name with external linkage the prefix of the unit, so that several units link into one program.
 * Compile each file with this one included before all others (-include, /FI). Where UNIT_IS_STATIC is
 * defined, FMI's functions get the prefix, too, as FMI wants it in a static library. */
#ifdef UNIT_IS_STATIC
#define FMI2_FUNCTION_PREFIX {prefix}
#define FMI3_FUNCTION_PREFIX {prefix}
#endif
"""


def names_header(prefix, texts):
    """The header that renames what the headers of a unit declare."""
    names = {f"tdmf_{file.removesuffix('.c')}" for file in texts if file.endswith("_motions.c")}
    for file, text in texts.items():
        if file.endswith(".h"):
            names |= set(re.findall(DECLARED, re.sub(NOT_CODE, "", text, flags=re.DOTALL), re.MULTILINE))
    return NAMES.format(prefix=prefix) + "".join(f"#define {name} {prefix}{name}\n" for name in sorted(names))


def included(text):
    """Names of the headers that a C file includes with quotes."""
    return re.findall(r'^\s*#\s*include "([^"]+)"', text, re.MULTILINE)


def shared_sources(texts):
    """The C files of every unit, and the headers that these and the page's own files include, by name."""
    found = {file.name: file for file in sorted(UNIT.glob("*.c"))}
    found |= {name: KERNEL / name for name in DRIVER}
    todo = [*texts.values(), *(file.read_text(encoding="utf-8") for file in found.values())]
    while todo:
        for name in included(todo.pop()):
            path = next((folder / name for folder in FOLDERS if (folder / name).is_file()), None)
            if path is not None and name not in found and name not in texts:
                found[name] = path
                todo.append(path.read_text(encoding="utf-8"))
    return found


def source_files(unit, texts):
    """All C files of a unit by name: those of the page and of its unit, and those that all units share."""
    files = texts | {name: path.read_text(encoding="utf-8") for name, path in shared_sources(texts).items()}
    return files | {"unit_names.h": names_header(f"{unit.identifier}_", files)}


def write_files(folder, files):
    """Write files whose texts have changed."""
    for name, text in files.items():
        path = Path(folder) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


def write_unit(model, folder, version="0"):
    """Write the unit of a page to a folder, and return its model identifier.

    Everything is C99 in the folder's `sources`, which need FMI's headers. `fmi2` and `fmi3` have what else is
    inside the FMUs of FMI 2.0 and 3.0: their model descriptions. `version` is that of the model.
    """
    unit, texts = unit_of(model, version)
    sources = source_files(unit, texts)
    compiled = {fmi: sources_of(sources, fmi) for fmi in (2, 3)}
    files = {f"sources/{name}": text for name, text in sources.items()}
    for fmi in (2, 3):
        files[f"fmi{fmi}/modelDescription.xml"] = description(unit, fmi, version, compiled[fmi])
    files["fmi3/sources/buildDescription.xml"] = build_description(unit, compiled[3])
    write_files(folder, files)
    return unit.identifier


def is_for(name, fmi):
    """True if a file in a unit's `sources` belongs to a version of FMI, 2 or 3."""
    return name != f"fmi{5 - fmi}.c"


def sources_of(names, fmi):
    """C files that are compiled for a version of FMI, 2 or 3, among the files in a unit's `sources`."""
    return sorted(name for name in names if name.endswith(".c") and is_for(name, fmi))


def host():
    """The name of this platform in FMI 3.0."""
    machine = platform.machine().lower()
    return f"{PROCESSORS.get(machine, machine)}-{platform.system().lower()}"


def platform_of(fmi, of=None):
    """The name of a platform, by default this one, in a version of FMI, and the suffix of its libraries.

    FMI 2.0 has one name for each system. It is that of x86_64, of this machine and, on macOS, of either
    processor; for other platforms the name is None.
    """
    of = of or host()
    machine, _, system = of.partition("-")
    name, suffix = SYSTEMS[system]
    is_named = machine == "x86_64" or system == "darwin" or of == host()
    return (of if fmi == 3 else name if is_named else None), suffix


def fmi_headers():
    """The folder of FMI's headers: FMI_HEADERS_DIR, else the one in FMPy."""
    given = os.environ.get("FMI_HEADERS_DIR")
    if given:
        return Path(given)
    found = importlib.util.find_spec("fmpy")
    if found is None:
        raise FileNotFoundError(
            "FMI's headers are missing: install FMPy, or set FMI_HEADERS_DIR to their folder"
        )
    return Path(found.origin).parent / "c-code"


def compile_unit(folder, compiler="cc", flags=()):
    """Compile a unit that `write_unit` wrote. Returns the objects by the names of their sources.

    `compiler` is a command that takes the options of GCC, as a string or a list. With `-DUNIT_IS_STATIC`
    among the `flags`, objects of several units may be linked into one program.
    """
    sources, objects = Path(folder) / "sources", Path(folder) / "objects"
    command = [compiler] if isinstance(compiler, str) else list(compiler)
    objects.mkdir(exist_ok=True)
    found, jobs, headers = {}, [], fmi_headers()
    for source in sorted(sources.glob("*.c")):
        found[source.name] = objects / f"{source.stem}.o"
        level = MOTIONS if source.name.endswith("_motions.c") or source.name == "driver.c" else ("-O2",)
        options = [*level, *FLAGS, *flags, "-include", sources / "unit_names.h", "-isystem", headers]
        job = [*command, *options, "-c", source, "-o", found[source.name]]
        jobs.append((source.name, job))
    run_all(jobs)
    return found


def run_all(jobs):
    """Run commands, as many at a time as there are processors; the first one that fails is reported."""

    def run(named):
        name, job = named
        done = subprocess.run(job, stderr=subprocess.PIPE, text=True)
        if done.returncode:
            raise RuntimeError(f"{name} does not compile:\n{done.stderr}")

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, jobs))


def build_library(folder, fmi, name, objects, compiler="cc", flags=(), of=None):
    """Link the objects of `compile_unit` to the shared library of a version of FMI for a platform.

    Returns its path, or None where the version of FMI has no name for the platform.
    """
    system, suffix = platform_of(fmi, of)
    if system is None:
        return None
    library = Path(folder) / f"fmi{fmi}" / "binaries" / system / f"{name}{suffix}"
    library.parent.mkdir(parents=True, exist_ok=True)
    command = [compiler] if isinstance(compiler, str) else list(compiler)
    linked = Path(folder) / "objects" / library.name
    sources = [objects[source] for source in sources_of(objects, fmi)]
    run_all([(library.name, [*command, "-shared", *flags, *sources, "-o", linked, "-lm"])])
    linked.replace(library)  # without what linkers for Windows write beside it
    return library


def build_units(model, folder, version="0", compiler="cc", flags=(), of=None, earlier=None):
    """Write, compile and pack the units of a page: the paths of its FMUs of FMI 2.0 and 3.0.

    The files in the folder are `NAME.fmu` and `NAME_FMI3.fmu`, where NAME is that of the page's class. `of`
    is the platform that the compiler compiles for, by default this one. `earlier` is a folder with units of
    the same page, whose libraries for other platforms are taken over.
    """
    folder = Path(folder)
    name, paths = write_unit(model, folder, version), []
    objects = compile_unit(folder, compiler, flags)
    for fmi in (2, 3):
        file = f"{name}{'' if fmi == 2 else '_FMI3'}.fmu"
        if earlier is not None and (Path(earlier) / file).is_file():
            unpack_binaries(Path(earlier) / file, folder / f"fmi{fmi}")
        build_library(folder, fmi, name, objects, compiler, flags, of)
        paths.append(pack_unit(folder, fmi, file))
    shutil.rmtree(folder / "objects")
    return paths


def unpack_binaries(unit, folder):
    """Unpack the binaries of a unit to a folder."""
    with zipfile.ZipFile(unit) as packed:
        for name in packed.namelist():
            if name.startswith("binaries/"):
                packed.extract(name, folder)


def pack_unit(folder, fmi, name):
    """Pack the unit of a version of FMI, with its sources and the binaries that are there."""
    folder = Path(folder)
    own = folder / f"fmi{fmi}"
    files = {file: file.relative_to(own).as_posix() for file in sorted(own.rglob("*")) if file.is_file()}
    sources = [file for file in sorted((folder / "sources").iterdir()) if is_for(file.name, fmi)]
    files |= {file: f"sources/{file.name}" for file in sources}
    with zipfile.ZipFile(folder / name, "w", zipfile.ZIP_DEFLATED) as packed:
        for file, inside in files.items():
            packed.write(file, inside)
    return folder / name
