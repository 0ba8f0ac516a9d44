"""Fixtures and data that many tests share: the FMU, reference gaits, commands, environments, the site."""

import contextlib
import dataclasses
import fcntl
import functools
import importlib
import importlib.resources
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import venv

import fmpy
import numpy as np
import pytest
import tdmf_slip
import xarray
from tdmf_slip.cli.main import main

RELEASE = os.environ.get("TDMF_SLIP_RELEASE") == "1"
"""True in `scripts/test --release`: samples are taken in full, and tests that take minutes run."""
release = pytest.mark.skipif(not RELEASE, reason="takes minutes: scripts/test --release")


HANGS = 1200.0
"""Seconds after which a process is said to hang, however busy the machine; nothing else depends on it."""


def pytest_collection_modifyitems(items):
    """Leave most tests of the live page on another screen to a release, and run tests of the site last.

    They run at a desk by default, with the mark `on_phone` on a phone, and with `both_screens` on both.
    scripts/test still builds the site while the first tests run.
    """
    for item in items:
        other = "desk" if "on_phone" in item.keywords else "phone in the dark"
        if f"[{other}" in item.name and "both_screens" not in item.keywords:
            item.add_marker(release)
    items.sort(key=lambda item: "site_build_ended" in item.fixturenames)


def some_of(cases, count):
    """Picks up to so many of some cases, evenly from the first one on; with --release it takes all."""
    cases = list(cases)
    return cases if RELEASE else cases[:: -(-len(cases) // count)]


@pytest.fixture(scope="session", autouse=True)
def interrupts_are_heard():
    """Restores interrupts: a shell's background jobs, and the processes they start, ignore them."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session", autouse=True)
def temporary_files_go(tmp_path_factory):
    """Chromium, Dask and rattler-build leave folders behind where temporary files are: here one that goes.

    Its name is short, for sockets in it, whose paths are allowed some hundred characters.
    """
    tmp_path_factory.getbasetemp()  # pytest's own stays where it is
    with (
        tempfile.TemporaryDirectory(prefix="tdmf-", ignore_cleanup_errors=True) as folder,
        pytest.MonkeyPatch.context() as patch,
    ):
        patch.setenv("TMPDIR", folder)
        patch.setattr(tempfile, "tempdir", folder)
        yield


@pytest.fixture(scope="session")
def browsers():
    """Gives the browser of a screen (width, height, whether it is dark), which is started once and stays."""
    sys.path.insert(0, str(ROOT / "documentation" / "live"))
    from browser import chromium

    with contextlib.ExitStack() as stack:
        browser = functools.cache(lambda *screen: stack.enter_context(chromium(*screen)))
        yield lambda width, height, dark=False: browser(width, height, dark)


@pytest.fixture(scope="session")
def site_build_ended():
    """Wait until no site is being built: the build holds this lock."""
    with locked("site"):
        pass


@pytest.fixture(scope="session")
def site(site_build_ended):
    """The folder of the built site."""
    folder = ROOT / "dist" / "site"
    if not (folder / "live.html").is_file():
        pytest.skip("NOT TESTED: the site; ./scripts/site builds it")
    return folder


@pytest.fixture(scope="session")
def runner():
    """The default runner."""
    return tdmf_slip.Runner()


@pytest.fixture(scope="session")
def gait():
    """The default runner's gait, at friction 0.6."""
    return tdmf_slip.find_gait()


@pytest.fixture(scope="session")
def load_example():
    """Imports a program of the examples by its name."""

    def load(name):
        with pytest.MonkeyPatch.context() as patch:
            patch.syspath_prepend(ROOT / "examples")
            return importlib.import_module(name)

    return load


@pytest.fixture(scope="session")
def ball():
    """The ball that `new` begins from scratch, built."""
    import own_pages

    return own_pages.my_ball()


@pytest.fixture(scope="session")
def my_runner():
    """The runner that `new` begins, built: it has gains in stance, without which it is the paper's."""
    import own_pages

    return own_pages.my_runner()


@pytest.fixture(scope="session")
def whole():
    """The whole runner's page, compiled."""
    from runner_pages import whole_page

    return whole_page()


@pytest.fixture(scope="session")
def fmu_file():
    """The unit that is installed with the package."""
    return str(tdmf_slip.fmu_path())


@pytest.fixture(scope="session")
def fmu():
    return tdmf_slip.load_fmu()


@pytest.fixture(scope="session")
def description(fmu_file):
    return fmpy.read_model_description(fmu_file)


@pytest.fixture(scope="session")
def unpacked(fmu_file, tmp_path_factory):
    return fmpy.extract(fmu_file, str(tmp_path_factory.mktemp("unit")))


@pytest.fixture(scope="session")
def fmu3():
    """The installed unit of FMI 3."""
    return str(tdmf_slip.fmu_path(fmi=3))


@pytest.fixture(scope="session")
def description3(fmu3):
    return fmpy.read_model_description(fmu3)


@pytest.fixture(scope="session")
def unpacked3(fmu3, tmp_path_factory):
    return fmpy.extract(fmu3, str(tmp_path_factory.mktemp("unit3")))


QUANTITIES = ("period", "length", "speed", "work", "cost_of_transport")
"""Quantities of a stride that importers and platforms are compared by."""
CLAMPED = {"hip.swing_clamp": True}
"""Setting of the runners whose references were computed with the clamp of the swing."""


def reference_gaits(*readings):
    """The published gaits for these values of `hip.swing_clamp`; both values by default."""
    file = importlib.resources.files("tdmf_slip.paper").joinpath("reference_gaits.json")
    gaits = json.loads(file.read_text(encoding="utf-8"))["gaits"]
    return [gait for gait in gaits if gait["swing_clamp"] in (readings or (False, True))]


def runner_of_gait(gait):
    """Start values of a reference gait that are not Table 1's."""
    return {"ground.friction": gait["friction"], "hip.swing_clamp": gait["swing_clamp"]}


def unit_reference():
    """The gait of the unit's own start values."""
    return next(gait for gait in reference_gaits(False) if gait["friction"] == 0.6)


def in_units(mass, stiffness, length, **values):
    """The default runner, with other values, in units of a mass, kg, a stiffness, N/m, and a length, m."""
    usual, time, energy = tdmf_slip.Runner(values), math.sqrt(mass / stiffness), stiffness * length**2
    scales = {"body.mass": mass, "foot.mass": mass, "leg.stiffness": stiffness, "leg.damping": mass / time}
    scales |= {"gravity": stiffness * length / mass, "leg.free_length": length, "leg.min_length": length}
    scales |= {"hip.stance_torque": energy, "hip.kp": energy, "hip.kd": energy * time}
    return usual.replace({name: usual[name] * scale for name, scale in scales.items()})


class Command:
    """The command `tdmf-slip`, run in this process."""

    def __init__(self, capsys):
        self.capsys = capsys

    def __call__(self, *arguments):
        """The command's status, and what it prints to stdout and to stderr."""
        status = main([str(argument) for argument in arguments])
        said = self.capsys.readouterr()
        return status, said.out, said.err

    def json(self, *arguments):
        """The object that a command prints that has to succeed."""
        status, out, said = self(*arguments, "--json")
        assert status == 0, said
        return json.loads(out)

    def refusal(self, *arguments):
        """The one message of a command that has to be refused."""
        status, out, said = self(*arguments)
        assert (status, out, len(said.strip().splitlines())) == (2, "", 1), said
        return said


@pytest.fixture
def command(capsys, tmp_path, monkeypatch):
    """The command in an empty folder."""
    monkeypatch.chdir(tmp_path)
    return Command(capsys)


def assert_same(one, other):
    """Compares results made anew number by number; NaN equals NaN."""
    assert type(one) is type(other)
    if isinstance(one, xarray.Dataset):
        assert one.identical(other)
        return
    np.testing.assert_equal(_plain(one), _plain(other))


def _plain(result):
    if isinstance(result, list | tuple):
        return [of.to_dict() if isinstance(of, xarray.Dataset) else _plain(of) for of in result]
    if not dataclasses.is_dataclass(result):
        return result
    return {of.name: _plain(getattr(result, of.name)) for of in dataclasses.fields(result)}


# ---- what is installed elsewhere ----


ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command, **options):
    """Runs a command to its end; returns its status and what it prints."""
    options = {"capture_output": True, "text": True, "timeout": HANGS, **options}
    return subprocess.run(list(map(str, command)), **options)


def run_python(*arguments, **options):
    """Runs Python in a process of its own."""
    return run(sys.executable, *arguments, **options)


def succeed(*command, **options):
    """Runs a command that has to succeed, and returns what it prints."""
    done = run(*command, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@contextlib.contextmanager
def locked(name):
    """Lets one worker at a time build in a folder of `build`."""
    (ROOT / "build").mkdir(exist_ok=True)
    with (ROOT / "build" / f"{name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@pytest.fixture(scope="session")
def made_once(tmp_path_factory):
    """Function that returns a folder for all workers; the first worker that asks for it has it filled."""
    own = tmp_path_factory.getbasetemp()
    all_workers = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own

    def folder_of(name, fill):
        folder, filled = all_workers / name, all_workers / f"{name} is filled"
        with locked(name):
            if not filled.exists():
                shutil.rmtree(folder, ignore_errors=True)
                folder.mkdir()
                fill(folder)
                filled.touch()
        return folder

    return folder_of


@pytest.fixture(scope="session")
def installed_library(made_once):
    """Folder into which `cmake --install` has put the library.

    CMake and its flags are those of the package, and the folder is as deep. Then the compiler's commands are
    the same, and ccache has their results where scripts/test has set it up.
    """
    build, programs = ROOT / "build" / "library", pathlib.Path(sys.executable).parent
    cmake = shutil.which("cmake", path=f"{programs}{os.pathsep}{os.environ['PATH']}")

    def install(prefix):
        options = ("-DTDMF_SLIP_BUILD_FMU=OFF", "-DTDMF_SLIP_WARNINGS_ARE_ERRORS=ON")
        succeed(cmake, "-S", ROOT, "-B", build, *options)
        succeed(cmake, "--build", build, "--parallel", "2")
        succeed(cmake, "--install", build, "--component", "library", "--prefix", prefix)

    return made_once("library", install)


@pytest.fixture(scope="session")
def wheel(made_once):
    """This machine's wheel, from the folder in which the installed package was built."""

    def pack(folder):
        options = ("--no-deps", "--no-build-isolation", "--no-index", "--disable-pip-version-check")
        succeed(sys.executable, "-m", "pip", "wheel", *options, "--wheel-dir", folder, ROOT)

    (path,) = made_once("wheel", pack).glob("*.whl")
    return path


COMPILING = (
    "CC",
    "CCACHE_BASEDIR",
    "CCACHE_DIR",
    "CCACHE_SLOPPINESS",
    "CMAKE_C_COMPILER_LAUNCHER",
    "CMAKE_GENERATOR",
    "SKBUILD_CMAKE_DEFINE",
)
"""Variables by which scripts/test lets nothing be compiled twice."""


class Environment:
    """A virtual environment that sees the packages of this one, but for tdmf_slip's own installation."""

    def __init__(self, folder):
        venv.create(folder, with_pip=False, symlinks=True)
        (packages,) = folder.glob("lib/*/site-packages")
        (packages / "others.pth").write_text(sysconfig.get_paths()["purelib"] + "\n", encoding="utf-8")
        self.folder = folder
        self.programs = folder / "bin"

    def install(self, package, path=None):
        """Installs a package; only the environment itself is on the PATH unless `path` is given."""
        variables = {"PATH": path or str(self.programs), "HOME": str(self.folder)}
        if path is not None:
            variables |= {name: os.environ[name] for name in COMPILING if name in os.environ}
        options = ("--no-deps", "--no-build-isolation", "--ignore-installed", "--disable-pip-version-check")
        pip = (self.programs / "python", "-m", "pip", "install")
        succeed(*pip, *options, "--no-index", package, env=variables)
        return variables

    def python(self, *arguments):
        """Output of the environment's Python, run far from the sources."""
        variables = {"PATH": str(self.programs), "HOME": str(self.folder)}
        return succeed(self.programs / "python", *arguments, env=variables, cwd=self.folder)


@pytest.fixture
def environment(tmp_path):
    """An environment for packages of one's own."""
    return Environment(tmp_path / "environment")
