"""Pages of equations, derived, compiled and run by the plain driver."""

import ast
import functools
import hashlib
import importlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
import types
from pathlib import Path

import numpy as np
from cffi import FFI
from conftest import locked

ROOT = Path(__file__).resolve().parents[2]
if str(ROOT) not in sys.path:
    sys.path.append(str(ROOT))  # the folder c_core is imported from the tree

from c_core.hybrid.limits import MARGINS  # noqa: E402

FLAGS = ["-std=c99", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-Wall", "-Wextra", "-Werror"]
LOG_SIZE = 500


KERNEL = ROOT / "c_core" / "hybrid" / "kernel", ROOT / "c_core" / "kernel"
"""Folders of the driver, of batches, and of what they include."""


def declared(*headers):
    """A cffi interface to what headers of the kernel declare, without what is for the compiler alone."""
    text, seen = "typedef struct tdmf_motion_kind tdmf_motion_kind;", {"motion.h"}

    def read(name):
        nonlocal text
        path = next((folder / name for folder in KERNEL if (folder / name).is_file()), None)
        if path is None or name in seen:
            return
        seen.add(name)
        own = path.read_text(encoding="utf-8")
        for included in re.findall(r'^#include "(.*)"', own, re.MULTILINE):
            read(included)
        own = re.sub(r"/\*.*?\*/", "", own, flags=re.DOTALL)
        own = re.sub(r"^static inline .*?^}|^#.*?[^\\]$", "", own, flags=re.DOTALL | re.MULTILINE)
        text += own.replace("[TERMS]", "[1]")

    for header in headers:
        read(header)
    made = FFI()
    made.cdef(text)
    return made


ffi = declared("batch.h", "section.h")
OUTCOMES = [
    name.removeprefix("TDMF_RUN_").lower().replace("_", "-")
    for _, name in sorted(ffi.typeof("tdmf_run_outcome").elements.items())
]


def numbers(array):
    """The C pointer to an array of doubles, which the caller keeps; NULL for an empty one."""
    return ffi.cast("double *", array.ctypes.data) if array.size else ffi.NULL


BEHIND = 8


def garbage(size):
    """Working memory that is not cleared, and some numbers behind it that no run may write."""
    return np.full(size + BEHIND, np.nan)


class StuckError(RuntimeError):
    """A chain of events in zero time does not end."""


def central_difference(ends, step):
    """The derivative by values at -2, -1, 1 and 2 steps, with an error of fourth order."""
    return (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / (12 * step)


LANES = {2: ("TDMF_HAS_TWO_LANES", "")}
if platform.machine().lower() in ("x86_64", "amd64"):
    LANES[4] = "TDMF_HAS_AVX2", "-mavx2"
    LANES[8] = "TDMF_HAS_AVX512", "-mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512"
"""Macro of a build with lanes, and the compiler's flags, by the number of lanes."""


def compiler():
    """The command of the compiler, behind ccache where there is one."""
    has_cache = shutil.which("ccache") and "CCACHE_DIR" in os.environ
    return ["ccache", "cc"] if has_cache else ["cc"]


def built_once(name, texts, fill):
    """A folder in `build/pages` that all workers share; the first that asks for these texts has it filled."""
    key = hashlib.sha256(repr(texts).encode()).hexdigest()[:16]
    pages = ROOT / "build" / "pages"
    pages.mkdir(parents=True, exist_ok=True)
    folder = pages / f"{name}-{key}"
    with locked(f"pages/{folder.name}"):
        if not folder.exists():
            with tempfile.TemporaryDirectory(dir=pages) as temporary:
                made = Path(temporary, "made")
                made.mkdir()
                fill(made)
                made.rename(folder)
    return folder


def compile_all(sources, folder, includes):
    """Compile C files, each with flags of its own, side by side: objects in a folder."""
    command = [*compiler(), *FLAGS, *(f"-I{path}" for path in includes)]
    running = [
        subprocess.Popen([*command, *flags.split(), "-c", source, "-o", folder / f"{i}.o"])
        for i, (source, flags) in enumerate(sources)
    ]
    assert sum(job.wait() for job in running) == 0, "the C does not compile"


def in_each_width(source, level):
    """A source with the flags of each number of lanes."""
    return [(source, f"{level} -DTDMF_LANES={n} -Wno-psabi {flags}") for n, (_, flags) in LANES.items()]


@functools.cache
def kernel(folders, in_lanes, macros):
    """Objects of the driver, which are those of every page."""
    files = [file for folder in folders for file in sorted(folder.iterdir())]
    has = [macro for macro, _ in LANES.values()] + ["TDMF_HAS_SEED_LANES"]
    flags = " ".join(["-O1", macros, *(f"-D{macro}" for macro in has if in_lanes)])
    lanes = folders[0] / "batch_lanes.c"
    sources = [(file, flags) for file in files if file.suffix == ".c" and file != lanes]
    sources += in_each_width(lanes, flags) if in_lanes else []
    texts = [(file.name, file.read_text(encoding="utf-8")) for file in files]
    made = built_once("kernel", [flags, texts], lambda folder: compile_all(sources, folder, folders))
    return flags, sorted(made.glob("*.o"))


def library_of(files, name, level, folders, in_lanes, macros):
    """Path of a library: derived C, compiled once for equal texts, and the driver."""
    flags, objects = kernel(folders, in_lanes, macros)

    def fill(folder):
        for file, text in files.items():
            (folder / file).write_text(text, encoding="utf-8")
        motions = folder / f"{name}_motions.c"
        sources = [(motions, f"{flags} {level}"), (folder / f"{name}.c", f"{flags} {level}")]
        if in_lanes:
            sources += [(folder / f"{name}_seeds.c", f"{flags} {level}"), *in_each_width(motions, level)]
        compile_all(sources, folder, (folder, *folders))
        own = [folder / f"{i}.o" for i in range(len(sources))]
        subprocess.run(
            ["cc", "-shared", *own, *objects, "-pthread", "-o", folder / "page.so", "-lm"], check=True
        )

    texts = [level, macros, [str(path) for path in objects], sorted(files.items())]
    return str(built_once(name, texts, fill) / "page.so")


@functools.cache
def digest():
    """Digest of the generator, the runner's page, and the C that all pages and units share."""
    folders = *(ROOT / "c_core" / name for name in ("hybrid", "kernel", "pages")), ROOT / "fmu_src"
    files = sorted(file for folder in folders for file in folder.rglob("*.[pch]*") if file.suffix != ".pyc")
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def texts_of(model):
    """Texts that determine the C derived from a model of a module."""
    file = Path(sys.modules[model.__module__].__file__)
    return [model.__qualname__, file.read_text(encoding="utf-8"), digest(), sorted(MARGINS.items())]


def derived(model):
    """Keys of a page's modes, and its C by file. What is derived from a model of a module is kept."""
    language = next(c.__module__ for c in model.__mro__ if c.__name__ == "Model").removesuffix("model")

    def derive():
        page = importlib.import_module(f"{language}page").Page(model)
        writes = importlib.import_module(f"{language}generate")
        return page.keys, writes.generate(page) | writes.seeds_of(page)

    if "<locals>" in model.__qualname__:
        return derive()
    made = built_once(
        f"derived-{model.__name__}",
        [language, *texts_of(model)],
        lambda folder: (folder / "page").write_text(repr(derive()), encoding="utf-8"),
    )
    return ast.literal_eval((made / "page").read_text(encoding="utf-8"))


GUIDE = ROOT / "documentation" / "development" / "pages.md"


def code_of_guide():
    """The code of the guide of the language."""
    return "\n".join(re.findall(r"```python\n(.*?)```", GUIDE.read_text(encoding="utf-8"), re.S))


@functools.cache
def guide():
    """The examples of the guide of the language, as a module."""
    module = sys.modules["guide_of_pages"] = types.ModuleType("guide_of_pages")
    module.__file__ = str(GUIDE)
    exec(compile(code_of_guide(), GUIDE, "exec"), vars(module))
    return module


class CompiledPage:
    """A page in C."""

    def __init__(self, model, level="-O0", folders=KERNEL, in_lanes=False, macros=""):
        self.model = model
        self.keys, self.files = derived(model)
        self.name = next(iter(self.files)).removesuffix(".h")
        path = library_of(self.files, self.name, level, folders, in_lanes, macros)
        own, variable = FFI(), f"tdmf_{self.name}_model"
        own.include(ffi)
        own.cdef(f"extern tdmf_model_kind {variable};")
        self.library, self.struct = ffi.dlopen(path), own.addressof(own.dlopen(path), variable)
        self.modes, self.events, self.states, self.parameters, self.outputs, self.tables, self.sections = (
            [
                ffi.string(getattr(self.struct, f"{kind}_names")[i]).decode()
                for i in range(getattr(self.struct, f"{kind}_count"))
            ]
            for kind in ("mode", "event", "state", "parameter", "output", "table", "section")
        )

    def names(self, values):
        """Values by the names of the page, from values by the names of a unit; "-2 deg" is an angle."""
        of = {self.model.public(n): n for n in [*self.states, *self.parameters]}

        def number(value):
            return np.radians(float(value.split()[0])) if isinstance(value, str) else value

        return {of[name]: number(value) for name, value in values.items()}

    def start(self, seeds=(), tolerance=1e-11, step_limit=100000, tables=(), **values):
        """A run from the page's start, with these values of parameters and states, and these tables."""
        return PageRun(self, list(seeds), tolerance, step_limit, dict(tables), values)

    def section(self, name, longest=1e6, **given):
        """The return map of a section, of a run that is given as in `start`."""
        return PageSection(self, self.sections.index(name), self.start(**given), longest)

    def map(self, name, mode, p, x, dp=None, dx=None):
        """The map "to_world", "from_world" or "world_rates" of a mode; its variation where `dx` is given."""
        given = [p, x] if dx is None else [p, x, dp, dx]
        values = given[-1].copy()
        self.call(name if dx is None else f"vary_{name}", mode, *given, values)
        return values

    def call(self, name, mode, *arrays):
        """Call a function of a mode, if it has that function."""
        if function := getattr(self.struct.modes[mode], name):
            function(*map(numbers, arrays))


class PageSection:
    """A return map of a page."""

    def __init__(self, of, index, run, longest):
        self.of, self.given, at = of, run, of.model.marked("is_section")[of.sections[index]]
        self.count, run.run.log_size = len(at.coordinates), 0
        self.memory = garbage(of.library.tdmf_section_memory_size(of.struct, index, len(run.seeds)))
        self.map = ffi.new("tdmf_section_map *", [of.struct, index, run.run, longest, numbers(self.memory)])
        self.x = np.zeros(len(of.states))
        self.dx = np.zeros((self.count + len(run.seeds), len(of.states)))

    def after(self, point, varies=False):
        """The next crossing: its point, and the derivatives by the point and the seeds where it `varies`."""
        given = self.map, list(point), varies, numbers(self.x), numbers(self.dx)
        return self.found(self.of.library.tdmf_next_crossing(*given))

    def found(self, crossing):
        self.crossing, self.outcome = crossing, OUTCOMES[crossing.outcome]
        self.mode, self.next = self.of.modes[crossing.mode], np.array(list(crossing.next))[: self.count]
        varied = np.array([list(row) for row in crossing.varied])[: self.count]
        self.jacobian = varied[:, : self.count]
        self.by_seeds = varied[:, self.count : self.count + len(self.given.seeds)]
        return self

    def fixed_point(self, guess):
        """The fixed point by Newton's method from a guess; `outcome` says whether the last run closed."""
        last = ffi.new("tdmf_crossing *")
        found = self.of.library.tdmf_find_crossing(self.map, list(guess), last)
        self.found(last)
        assert found.outcome == 0, f"no fixed point: {found.outcome}, error {found.error}"
        return np.array(list(found.point))[: self.count]

    def state(self, name):
        """A state at the crossing."""
        return self.x[self.of.states.index(name)]


class PageRun:
    """A run of a page: its states and parameters by name, and variations by `seeds`, names of either."""

    def __init__(self, of, seeds, tolerance, step_limit, tables, values):
        self.of, self.seeds = of, seeds
        self.p, self.x = np.zeros(max(1, len(of.parameters))), np.zeros(max(1, len(of.states)))
        self.memory = garbage(of.library.tdmf_run_memory_size(of.struct, len(seeds)))
        arrays = (numbers(array) for array in (self.p, self.x, self.memory))
        self.run = ffi.new("tdmf_page_run *", of.library.tdmf_run_default(of.struct, *arrays))
        self.run.tolerance, self.run.order = tolerance, of.library.tdmf_page_order(tolerance)
        self.run.step_limit = step_limit
        self.tables = [np.array(tables.get(name, []), dtype=float, ndmin=2) for name in of.tables]
        rows = [[*table.shape, numbers(table)] for table in self.tables]
        self.run.tables = self.table_structs = ffi.new("tdmf_table[]", [*rows, []])
        for name, value in values.items():
            array, place = self._place(name)
            array[place] = value
        self.dp, self.dx = np.zeros((len(seeds) + 1, len(self.p))), np.zeros((len(seeds) + 1, len(self.x)))
        for i, name in enumerate(seeds):
            (self.dx if name in of.states else self.dp)[i, self._place(name)[1]] = 1
        self.shift, self.run.log_size = np.zeros(len(seeds) + 1), LOG_SIZE
        self.run.seed_count, self.run.dp, self.run.dx = len(seeds), numbers(self.dp), numbers(self.dx)
        self.run.shift = numbers(self.shift)
        self.run.log = self.rows = ffi.new("tdmf_event_row[]", LOG_SIZE)
        self.outcome = None

    def vary_table(self, number, direction):
        """Vary a table with the first seed."""
        self.varied_table = direction
        self.table_structs[number].d_rows = numbers(direction)

    def _place(self, name):
        if name in self.of.states:
            return self.x, self.of.states.index(name)
        return self.p, self.of.parameters.index(name)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        values, place = self._place(name)
        return values[place]

    def set(self, **values):
        """Set quantities as an importer does, with what else changes there."""
        for name, value in values.items():
            given = name in self.of.states, self._place(name)[1], value
            self.of.library.tdmf_page_set(self.of.struct, self.run, *given)
        return self

    def to(self, until=1e6, stop=None):
        """Run until a time, or to an event."""
        self.run.stop_event = self.of.events.index(stop) if stop else -1
        self.outcome = OUTCOMES[self.of.library.tdmf_page_run_to(self.of.struct, self.run, until)]
        if self.outcome == "endless-chain":
            raise StuckError(self.message)
        return self

    @property
    def message(self):
        """The outcome in a sentence."""
        text = ffi.new("char[]", 500)
        outcome = OUTCOMES.index(self.outcome)
        self.of.library.tdmf_run_message(self.of.struct, self.run, outcome, text, len(text))
        return ffi.string(text).decode()

    def sample_at(self, times):
        """Sample the outputs at some times of the run. Returns arrays by time and output, for their values,
        and by time, seed and output, for their variations."""
        times, count = np.array(times, dtype=float), len(self.of.outputs)
        self.sampled = times, np.zeros((len(times), count)), np.zeros((len(times), len(self.seeds), count))
        run = self.run
        run.sample_times, run.samples, run.d_samples = map(numbers, self.sampled)
        run.sample_count, run.sampled = len(times), 0
        return self.sampled[1:]

    def sample(self, times):
        """Outputs at some times, by time and output, and their variations, by time, seed and output."""
        values, varied = self.sample_at(times)
        self.to(times[-1])
        self.run.sample_count = 0
        return values[: self.run.sampled], varied[: self.run.sampled]

    @property
    def time(self):
        return self.run.time

    @property
    def mode(self):
        return self.of.modes[self.run.mode]

    def page(self):
        """The page at this instant, on plain numbers."""
        key = self.of.keys[self.run.mode]
        values = dict(zip(self.of.parameters, map(float, self.p), strict=False))
        return self.of.model.at(
            key[0], **dict(key[1]), **values, **dict(zip(self.of.states, map(float, self.x), strict=False))
        )

    def d(self, name):
        """Variations of a state, by seed."""
        return self.dx[: len(self.seeds), self.of.states.index(name)]

    def world(self):
        """The world's states by name, those that the mode's coordinates give and all others."""
        values = self.of.map("to_world", self.run.mode, self.p, self.x)
        return dict(zip(self.of.states, values, strict=False))

    @property
    def outputs(self):
        """Outputs by name."""
        values = np.zeros(len(self.of.outputs) + 1)
        self.of.call("outputs", self.run.mode, self.p, self.x, values)
        return dict(zip(self.of.outputs, values, strict=False))

    @property
    def log(self):
        rows = self.rows[0 : min(LOG_SIZE, self.run.log_count)]
        return [
            (r.time, self.of.events[r.event], self.of.modes[r.before], self.of.modes[r.after]) for r in rows
        ]


def run_batch(runs, until=1e6, stop=None, width=0, threads=1, at_end=None, cancel=ffi.NULL):
    """Run many runs of a page side by side. Returns the work done."""
    of, work = runs[0].of, ffi.new("tdmf_batch_work *")
    structs, outcomes = ffi.new("tdmf_page_run[]", len(runs)), ffi.new("tdmf_run_outcome[]", len(runs))
    untils = np.full(len(runs), until, float) if np.isscalar(until) else np.asarray(until, float)
    for i, run in enumerate(runs):
        run.run.stop_event = of.events.index(stop) if stop else -1
        structs[i] = run.run[0]
    at_end = ffi.callback("tdmf_at_end", at_end) if at_end else ffi.NULL
    batch = ffi.new("tdmf_batch *", [structs, len(runs), numbers(untils), outcomes, at_end, ffi.NULL, cancel])
    batch.width, batch.threads = width, threads
    assert of.library.tdmf_run_batch(of.struct, batch, work), "the batch is refused"
    for i, run in enumerate(runs):
        run.run[0], run.outcome = structs[i], OUTCOMES[outcomes[i]]
    return work


def widths_of(page):
    """The numbers of lanes that this machine has."""
    return [width for width in (1, *LANES) if page.library.tdmf_batch_has_width(page.struct, width)]
