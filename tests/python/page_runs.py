"""Pages of equations, derived, compiled and run by the plain driver."""

import ast
import ctypes
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
from ctypes import (
    CFUNCTYPE,
    POINTER,
    Structure,
    byref,
    c_bool,
    c_char_p,
    c_double,
    c_int,
    c_int64,
    c_long,
    c_size_t,
    c_uint64,
    c_void_p,
)
from pathlib import Path

import numpy as np
from conftest import locked

ROOT = Path(__file__).resolve().parents[2]
if str(ROOT) not in sys.path:
    sys.path.append(str(ROOT))  # the folder c_core is imported from the tree

from c_core.hybrid.limits import MARGINS  # noqa: E402

COMPILER = shutil.which("cc")
FLAGS = ["-std=c99", "-ffp-contract=off", "-fno-math-errno", "-fPIC", "-Wall", "-Wextra", "-Werror"]
OUTCOMES = ["arrived", "stopped", "ended", "no-progress", "too-many-steps", "endless-chain"]
OUTCOMES += ["too-many-events", "no-memory", "cancelled", "bad-order", "too-many-seeds"]
LOG_SIZE = 500


class Row(Structure):
    _fields_ = [("time", c_double), ("event", c_int), ("before", c_int), ("after", c_int)]


class RunStruct(Structure):
    _fields_ = [
        *(("p", c_void_p), ("x", c_void_p), ("memory", c_void_p), ("tables", c_void_p)),
        *(("time", c_double), ("mode", c_int), ("tolerance", c_double)),
        *(("order", c_int), ("stop_event", c_int), ("observes", c_int)),
        *(("step_limit", c_long), ("event_limit", c_long)),
        *(("seed_count", c_int), ("dp", c_void_p), ("dx", c_void_p), ("shift", c_void_p)),
        *(("log", c_void_p), ("log_states", c_void_p), ("log_size", c_int), ("log_count", c_int)),
        *(("sample_times", c_void_p), ("samples", c_void_p), ("d_samples", c_void_p)),
        *(("sample_count", c_int), ("sampled", c_int)),
        *(("steps", c_long), ("events", c_long), ("limited_steps", c_long)),
        *(("chain", c_int), ("time_rest", c_double)),
        *(("is_shifted", c_bool), *((name, c_uint64) for name in ("taken", "above", "late"))),
    ]


class TableStruct(Structure):
    _fields_ = [
        *(("row_count", c_int), ("column_count", c_int), ("rows", c_void_p), ("d_rows", c_void_p)),
        *(("entry", CFUNCTYPE(c_double, c_void_p, c_double, c_int)), ("context", c_void_p)),
    ]


class ModeStruct(Structure):
    MAPS = ("to_world", "from_world", "world_rates")
    AT_INSTANTS = ("open", "vary_open", "outputs", "vary_outputs", "time_scale", "leave", "vary_leave")
    FUNCTIONS = (*AT_INSTANTS, *MAPS)
    _fields_ = [
        *(("motion", c_void_p), ("ends", c_bool), ("guard_count", c_int), ("guards", c_void_p)),
        *(("watch_count", c_int), ("usual_count", c_int), ("watches", c_void_p)),
        *((name, c_void_p) for name in FUNCTIONS),
        *((f"vary_{name}", c_void_p) for name in MAPS),
    ]


class ModelStruct(Structure):
    COUNTS = ("state_count", "parameter_count", "event_count", "mode_count", "output_count", "table_count",
              "set_count", "section_count")  # fmt: skip
    NAMES = ("mode_names", "event_names", "state_names", "parameter_names", "output_names", "table_names",
             "section_names")  # fmt: skip
    _fields_ = [
        *((name, c_int) for name in COUNTS),
        *(("modes", POINTER(ModeStruct)), ("sets", c_void_p), ("sections", c_void_p)),
        ("scales", c_void_p),
        *((name, c_int) for name in ("series_count", "constant_count")),
        *((name, POINTER(c_char_p)) for name in NAMES),
        *(("parameter_defaults", POINTER(c_double)), ("state_defaults", POINTER(c_double))),
    ]


MAP_LIMIT = 8


class SectionMap(Structure):
    _fields_ = [
        *(("model", c_void_p), ("section", c_int), ("run", c_void_p), ("longest", c_double)),
        ("memory", c_void_p),
    ]


class Crossing(Structure):
    _fields_ = [
        *(("outcome", c_int), ("mode", c_int), ("time", c_double), ("next", c_double * MAP_LIMIT)),
        ("varied", c_double * (2 * MAP_LIMIT) * MAP_LIMIT),
    ]


class FixedPoint(Structure):
    _fields_ = [
        *(("outcome", c_int), ("iterations", c_int), ("error", c_double)),
        *(("point", c_double * MAP_LIMIT), ("slot", c_int)),
    ]


BEHIND = 8


def garbage(size):
    """Working memory that is not cleared, and some numbers behind it that no run may write."""
    return np.full(size + BEHIND, np.nan)


class StuckError(RuntimeError):
    """A chain of events in zero time does not end."""


def central_difference(ends, step):
    """The derivative by values at -2, -1, 1 and 2 steps, with an error of fourth order."""
    return (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / (12 * step)


KERNEL = ROOT / "c_core" / "hybrid" / "kernel", ROOT / "c_core" / "kernel"
"""Folders of the driver, of batches, and of what they include."""


LANES = {2: ("TDMF_HAS_TWO_LANES", "")}
if platform.machine().lower() in ("x86_64", "amd64"):
    LANES[4] = "TDMF_HAS_AVX2", "-mavx2"
    LANES[8] = "TDMF_HAS_AVX512", "-mavx512f -mavx512dq -mavx512vl -mprefer-vector-width=512"
"""For each number of lanes, the macro that says that a build has them, and the compiler's flags."""


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
    """Compile derived C, once for equal texts, and link it with the driver."""
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
            [COMPILER, "-shared", *own, *objects, "-pthread", "-o", folder / "page.so", "-lm"], check=True
        )

    texts = [level, macros, [str(path) for path in objects], sorted(files.items())]
    return ctypes.CDLL(str(built_once(name, texts, fill) / "page.so"))


@functools.cache
def digest():
    """Digest of the generator, the runner's page, and the C that all pages and units share."""
    folders = *(ROOT / "c_core" / name for name in ("hybrid", "kernel", "pages")), ROOT / "fmu_src"
    files = sorted(file for folder in folders for file in folder.rglob("*.[pch]*") if file.suffix != ".pyc")
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def texts_of(model):
    """What decides the C that is derived from a model of a module."""
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
        self.library = library_of(self.files, self.name, level, folders, in_lanes, macros)
        self.struct = ModelStruct.in_dll(self.library, f"tdmf_{self.name}_model")
        self.modes, self.events, self.states, self.parameters, self.outputs, self.tables, self.sections = (
            [
                getattr(self.struct, names)[i].decode()
                for i in range(getattr(self.struct, names.replace("names", "count")))
            ]
            for names in ModelStruct.NAMES
        )
        self.library.tdmf_run_default.restype = RunStruct
        self.library.tdmf_run_default.argtypes = [c_void_p] * 4
        self.library.tdmf_run_memory_size.restype = c_size_t
        self.library.tdmf_section_memory_size.restype = c_size_t
        self.library.tdmf_page_order.argtypes = [c_double]

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
            CFUNCTYPE(None, *[c_void_p] * len(arrays))(function)(*(array.ctypes.data for array in arrays))


class PageSection:
    """A return map of a page."""

    def __init__(self, of, index, run, longest):
        self.of, self.given, at = of, run, of.model.marked("is_section")[of.sections[index]]
        self.count, run.run.log_size = len(at.coordinates), 0
        size = of.library.tdmf_section_memory_size(byref(of.struct), c_int(index), c_int(len(run.seeds)))
        self.memory = garbage(size)
        addresses = ctypes.addressof(of.struct), index, ctypes.addressof(run.run), longest
        self.map = SectionMap(*addresses, self.memory.ctypes.data)
        of.library.tdmf_next_crossing.restype = Crossing
        of.library.tdmf_find_crossing.restype = FixedPoint
        self.x = np.zeros(len(of.states))
        self.dx = np.zeros((self.count + len(run.seeds), len(of.states)))

    def after(self, point, varies=False):
        """The next crossing: its point, and the derivatives by the point and the seeds where it `varies`."""
        values = np.array(point, dtype=float)
        return self.found(
            self.of.library.tdmf_next_crossing(
                byref(self.map),
                c_void_p(values.ctypes.data),
                c_bool(varies),
                c_void_p(self.x.ctypes.data),
                c_void_p(self.dx.ctypes.data),
            )
        )

    def found(self, crossing):
        self.crossing, self.outcome = crossing, OUTCOMES[crossing.outcome]
        self.mode, self.next = self.of.modes[crossing.mode], np.array(crossing.next)[: self.count]
        varied = np.array(crossing.varied)[: self.count]
        self.jacobian = varied[:, : self.count]
        self.by_seeds = varied[:, self.count : self.count + len(self.given.seeds)]
        return self

    def fixed_point(self, guess):
        """The fixed point by Newton's method from a guess; `outcome` says whether the last run closed."""
        values, last = np.array(guess, dtype=float), Crossing()
        found = self.of.library.tdmf_find_crossing(byref(self.map), c_void_p(values.ctypes.data), byref(last))
        self.found(last)
        assert found.outcome == 0, f"no fixed point: {found.outcome}, error {found.error}"
        return np.array(found.point)[: self.count]

    def state(self, name):
        """A state at the crossing."""
        return self.x[self.of.states.index(name)]


class PageRun:
    """A run of a page: its states and parameters by name, and variations by `seeds`, names of either."""

    def __init__(self, of, seeds, tolerance, step_limit, tables, values):
        self.of, self.seeds = of, seeds
        self.p, self.x = np.zeros(max(1, len(of.parameters))), np.zeros(max(1, len(of.states)))
        self.memory = garbage(of.library.tdmf_run_memory_size(byref(of.struct), len(seeds)))
        arrays = (array.ctypes.data for array in (self.p, self.x, self.memory))
        self.run = of.library.tdmf_run_default(byref(of.struct), *arrays)
        self.run.tolerance, self.run.order = tolerance, of.library.tdmf_page_order(tolerance)
        self.run.step_limit = step_limit
        self.tables = [np.array(tables.get(name, []), dtype=float, ndmin=2) for name in of.tables]
        self.table_structs = (TableStruct * (len(self.tables) + 1))(
            *(TableStruct(*t.shape, t.ctypes.data if t.size else None, None) for t in self.tables)
        )
        self.run.tables = ctypes.addressof(self.table_structs)
        for name, value in values.items():
            self._place(name)[0][self._place(name)[1]] = value
        self.dp, self.dx = np.zeros((len(seeds) + 1, len(self.p))), np.zeros((len(seeds) + 1, len(self.x)))
        for i, name in enumerate(seeds):
            (self.dx if name in of.states else self.dp)[i, self._place(name)[1]] = 1
        self.shift, self.rows = np.zeros(len(seeds) + 1), (Row * LOG_SIZE)()
        self.run.seed_count, self.run.log_size = len(seeds), LOG_SIZE
        self.run.dp, self.run.dx, self.run.shift = (a.ctypes.data for a in (self.dp, self.dx, self.shift))
        self.run.log = ctypes.addressof(self.rows)
        self.outcome = None

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
            given = c_bool(name in self.of.states), c_int(self._place(name)[1]), c_double(value)
            self.of.library.tdmf_page_set(byref(self.of.struct), byref(self.run), *given)
        return self

    def to(self, until=1e6, stop=None):
        """Run until a time, or to an event."""
        self.run.stop_event = self.of.events.index(stop) if stop else -1
        outcome = self.of.library.tdmf_page_run_to(byref(self.of.struct), byref(self.run), c_double(until))
        self.outcome = OUTCOMES[outcome]
        if self.outcome == "endless-chain":
            raise StuckError(self.message)
        return self

    @property
    def message(self):
        """The outcome in a sentence."""
        text = ctypes.create_string_buffer(500)
        given = byref(self.of.struct), byref(self.run), OUTCOMES.index(self.outcome)
        self.of.library.tdmf_run_message(*given, text, c_size_t(len(text)))
        return text.value.decode()

    def sample_at(self, times):
        """Have the run sample its outputs at some times. Returns arrays by time and output, for their values,
        and by time, seed and output, for their variations."""
        times, count = np.array(times, dtype=float), len(self.of.outputs)
        self.sampled = times, np.zeros((len(times), count)), np.zeros((len(times), len(self.seeds), count))
        run = self.run
        run.sample_times, run.samples, run.d_samples = (a.ctypes.data for a in self.sampled)
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
        rows = self.rows[: min(LOG_SIZE, self.run.log_count)]
        return [
            (r.time, self.of.events[r.event], self.of.modes[r.before], self.of.modes[r.after]) for r in rows
        ]


AT_END = CFUNCTYPE(c_int, c_void_p, c_int64, POINTER(RunStruct), c_int)


class BatchStruct(Structure):
    _fields_ = [
        *(("runs", POINTER(RunStruct)), ("count", c_int64), ("until", c_void_p), ("outcomes", c_void_p)),
        *(("at_end", AT_END), ("context", c_void_p), ("cancel", POINTER(c_int)), ("width", c_int)),
        ("threads", c_int),
    ]


class WorkStruct(Structure):
    _fields_ = [(name, c_int64) for name in ("steps", "lane_steps", "single_steps")]


def run_batch(runs, until=1e6, stop=None, width=0, threads=1, at_end=None, cancel=None):
    """Run many runs of a page side by side. Returns the work done."""
    of, work = runs[0].of, WorkStruct()
    structs, outcomes = (RunStruct * len(runs))(), np.full(len(runs), -1, np.int32)
    untils = np.full(len(runs), until, float) if np.isscalar(until) else np.asarray(until, float)
    for i, run in enumerate(runs):
        run.run.stop_event = of.events.index(stop) if stop else -1
        structs[i] = run.run
    batch = BatchStruct(
        structs, len(runs), untils.ctypes.data, outcomes.ctypes.data, AT_END(at_end or 0), None, cancel,
        width, threads,
    )  # fmt: skip
    is_sound = of.library.tdmf_run_batch(byref(of.struct), byref(batch), byref(work))
    assert is_sound & 255, "the batch is refused"
    for i, run in enumerate(runs):
        run.run = RunStruct.from_buffer_copy(structs[i])
        run.outcome = OUTCOMES[outcomes[i]]
    return work


def widths_of(page):
    """The numbers of lanes that this machine has."""
    has = page.library.tdmf_batch_has_width
    return [width for width in (1, *LANES) if has(byref(page.struct), width) & 255]
