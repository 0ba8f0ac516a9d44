"""Results on file, by every command that writes: whole or not at all, where and as the user wants them."""

import json
import os
import pathlib
import signal
import stat
import sys
import time

import pytest
import xarray
from conftest import run_python, some_of
from tdmf_slip.files import netcdf, whole

HANGUP = getattr(signal, "SIGHUP", signal.SIGTERM)  # which Windows has not
POSIX_ONLY = pytest.mark.skipif(os.name != "posix", reason="modes, pipes and links are those of POSIX")
NETCDF = ("sweep", "--friction", "0.5:0.6:2", "--output", "{}.nc")
WRITERS = {
    "rows as NetCDF": ("simulate", "--stop-time", 2, "--output", "{}.nc"),
    "rows as CSV": ("simulate", "--stop-time", 2, "--output", "{}.csv"),
    "a plot": ("simulate", "--stop-time", 2, "--plot", "{}.png"),
    "a sweep": NETCDF,
    "a grid": ("sweep", "--friction", "0.6:0.6:1", "--vary", "leg.damping=0.2:0.2:1", "--output", "{}.nc"),
    "a map": ("basin", "--n", 2, "--samples", 0, "--output", "{}.nc"),
    "viable sets": (
        *("viability", "--axes", "com_height=1:2", "--axes", "com_speed=0.5:1.5"),
        *("--vary", "hip.touchdown_angle=0.3:1.1:3", "--n", 2, "--output", "{}.nc"),
    ),
    "a drawn map": ("basin", "--n", 2, "--samples", 0, "--plot", "{}.svg"),
}
FIGURE = "figure_1b.csv"
FIGURES = ("figures", "--only", "figure_1b", "--output")


def arguments(writer, name):
    return [str(word).replace("{}", name) for word in WRITERS[writer]]


def file_of(writer, name):
    return pathlib.Path(arguments(writer, name)[-1])


@pytest.fixture(params=WRITERS)
def writer(request):
    return request.param


@pytest.fixture(params=some_of(WRITERS, 2))
def one_of_the_writers(request):
    """Some of the writers, with --release all: one module makes every file of a new mode, link and name."""
    return request.param


FULL_DISK = """
import contextlib, io, json, os, resource, sys, tdmf_slip
from tdmf_slip.cli import main as command
there = tdmf_slip.load_fmu().folder  # unpacked before the disk is full
commands = json.load(sys.stdin)
sys.dont_write_bytecode = True  # Python would leave modules of 100 bytes for all who import them later
resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
for folder, options in commands.items():
    os.chdir(folder)
    said = io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
        status = command.main(options)
    print(json.dumps([folder, status, said.getvalue()]), file=sys.__stdout__)
"""


@pytest.fixture(scope="module")
def with_full_disk(tmp_path_factory):
    """Message, status and folder of each command that writes, when the process may write no more.

    A limit of what a process may write stands for the disk's end. All run in one process, after each other.
    """
    commands = {writer: arguments(writer, "result") for writer in WRITERS}
    commands["figures"] = [*FIGURES, "figures"]
    folders = {name: tmp_path_factory.mktemp("full") for name in commands}
    given = json.dumps({str(folders[name]): options for name, options in commands.items()})
    process = run_python("-c", FULL_DISK, input=given)
    assert process.returncode == 0, process.stderr
    assert "Traceback" not in process.stderr
    said = {folder: (status, text) for folder, status, text in map(json.loads, process.stdout.splitlines())}
    return {name: (*said[str(folder)], folder) for name, folder in folders.items()}


@POSIX_ONLY
def test_a_full_disk_is_told_and_nothing_is_left(writer, with_full_disk):
    status, text, folder = with_full_disk["figures"]
    assert status == 1 and "cannot be written: File too large" in text, text
    assert not any((folder / "figures").iterdir())
    status, text, folder = with_full_disk[writer]
    assert status == 1, text
    said = [line for line in text.splitlines() if line.startswith("tdmf-slip: ")]
    name = f"{file_of(writer, 'result')}: cannot be written: File too large"  # the user's, no temporary one
    assert len(said) == 1 and f"tdmf-slip: {name}" in said[0], text
    assert "Traceback" not in text
    assert list(folder.iterdir()) == []


@POSIX_ONLY
@pytest.mark.parametrize("kind", ["pipe", "device", "link in a circle"])
def test_what_is_no_file_is_refused_before_the_work(writer, kind, command, tmp_path):
    path = tmp_path / file_of(writer, "result")
    if kind == "pipe":
        os.mkfifo(path)
    else:
        path.symlink_to("/dev/null" if kind == "device" else path)
    before = path.lstat()
    message = command.refusal(*arguments(writer, "result"))
    reason = "symbolic links" if kind == "link in a circle" else "a pipe or device; allowed: a file"
    assert reason in message
    assert path.lstat().st_ino == before.st_ino and len(list(tmp_path.iterdir())) == 1


@POSIX_ONLY
def test_a_new_file_has_the_mode_of_any_new_file_and_one_that_is_replaced_its_own(
    one_of_the_writers, command, tmp_path
):
    file, mask = tmp_path / file_of(one_of_the_writers, "result"), os.umask(0o027)
    try:
        for mode in (0o640, 0o604):
            assert command(*arguments(one_of_the_writers, "result"))[0] == 0
            assert file.stat().st_mode & 0o7777 == mode and file.stat().st_size > 100
            file.chmod(0o604)
    finally:
        os.umask(mask)


@pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="only root gives files away")
def test_a_file_that_is_replaced_keeps_its_owner(command, tmp_path):
    file = tmp_path / "result.csv"
    file.touch()
    os.chown(file, 1234, 4321)
    assert command(*arguments("rows as CSV", "result"))[0] == 0
    assert (file.stat().st_uid, file.stat().st_gid) == (1234, 4321) and file.stat().st_size > 100


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may write to everything")
def test_a_file_that_may_not_be_written_is_refused(command, tmp_path):
    file = tmp_path / "result.csv"
    file.touch(mode=0o444)
    message = command.refusal(*arguments("rows as CSV", "result"))
    assert "Permission denied" in message and file.read_text() == ""


@POSIX_ONLY
def test_a_link_is_written_through_to_its_target(one_of_the_writers, command, tmp_path):
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    target, link = folder / "target", tmp_path / file_of(one_of_the_writers, "result")
    link.symlink_to(pathlib.Path("elsewhere", "target"))
    for _ in range(2):  # there is no file yet, then there is one
        assert command(*arguments(one_of_the_writers, "result"))[0] == 0
        assert link.is_symlink() and target.is_file() and target.stat().st_size > 100
    assert [file.name for file in folder.iterdir()] == ["target"]


NAME = os.fsdecode(b"caf\xe9")


@pytest.mark.skipif(sys.platform != "linux", reason="names that are no UTF-8 are allowed on Linux")
def test_a_name_need_not_be_utf_8(one_of_the_writers, command, tmp_path):
    """The folder and the file have such a name."""
    name = f"{NAME}/{NAME}"
    options = [*arguments(one_of_the_writers, name), "--json"]
    (tmp_path / file_of(one_of_the_writers, name)).parent.mkdir(exist_ok=True)
    for _ in range(2):  # the second time some go on with it
        assert command(*options)[0] == 0
    assert (tmp_path / file_of(one_of_the_writers, name)).stat().st_size > 100


def test_an_error_leaves_the_old_file_and_no_other(tmp_path):
    file = tmp_path / "old.csv"
    file.write_text("old")

    with pytest.raises(ZeroDivisionError), whole.whole(file) as beside:
        beside.write_text("new")
        assert beside.parent == tmp_path and beside.suffix == ".csv" and file.read_text() == "old"
        _ = 1 / 0
    assert [path.name for path in tmp_path.iterdir()] == ["old.csv"] and file.read_text() == "old"


@POSIX_ONLY
def test_an_interrupt_waits_until_a_dataset_is_written(tmp_path, monkeypatch):
    """Rows that took minutes are not lost; any other file is written whole or not at all."""
    honest, file = os.replace, tmp_path / "new.nc"

    def replace(*paths):
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.3)
        honest(*paths)

    monkeypatch.setattr(os, "replace", replace)
    with pytest.raises(KeyboardInterrupt):
        netcdf.write_dataset(file, xarray.Dataset({"a": 1}))
    assert [path.name for path in tmp_path.iterdir()] == ["new.nc"] and xarray.load_dataset(file)["a"] == 1
    with pytest.raises(KeyboardInterrupt), whole.whole(tmp_path / "new.csv"):
        signal.raise_signal(signal.SIGINT)
    assert [path.name for path in tmp_path.iterdir()] == ["new.nc"]


@POSIX_ONLY
def test_a_file_is_on_the_disk_before_it_has_its_name(monkeypatch, tmp_path):
    """The folder is flushed after the renaming, before the file counts as written."""
    happened = []
    flushed, replaced = os.fsync, os.replace

    def fsync(handle):
        is_folder = stat.S_ISDIR(os.fstat(handle).st_mode)
        happened.append("folder" if is_folder else f"file of {os.fstat(handle).st_size}")
        flushed(handle)

    def replace(here, there):
        happened.append("renamed")
        replaced(here, there)

    monkeypatch.setattr(os, "fsync", fsync)
    monkeypatch.setattr(os, "replace", replace)
    with whole.whole(tmp_path / "new.csv") as beside:
        beside.write_text("twelve bytes")
    assert happened == ["file of 12", "renamed", "folder"]


@POSIX_ONLY
def test_the_mask_of_the_process_is_left_alone(monkeypatch, tmp_path):
    """All threads share the mask, and others may be making files."""
    monkeypatch.setattr(os, "umask", lambda mask: pytest.fail("the mask was changed"))
    for mode in (None, 0o600):  # until a file is replaced its successor is nobody else's
        with whole.whole(tmp_path / "new.csv") as beside:
            beside.write_text("new")
            assert mode in (None, stat.S_IMODE(beside.stat().st_mode))
    assert (tmp_path / "new.csv").read_text() == "new"


TERMINATED = """
import os, sys, tempfile
import tdmf_slip
from tdmf_slip import __main__
from tdmf_slip.files import whole
from tdmf_slip.fmu import run as tables
from tdmf_slip.cli import simulate

real = simulate.run_unit
when, number = sys.argv.pop(), int(sys.argv.pop())


def ending(*given, **named):
    run = real(*given, **named)  # the unit is unpacked
    assert any(os.scandir(tempfile.gettempdir()))
    if when == "in a file":
        tables.WRITERS[".csv"] = lambda *_: os.kill(os.getpid(), number)
        return run
    os.kill(os.getpid(), number)
    raise AssertionError("goes on")


simulate.run_unit = ending
sys.exit(__main__.main())
"""


@POSIX_ONLY
@pytest.mark.parametrize(("when", "number"), [("in a file", signal.SIGTERM), ("after a run", HANGUP)])
def test_a_request_to_end_leaves_nothing_in_temporary_folders(when, number, tmp_path):
    (tmp_path / "temporary").mkdir()
    options = ["simulate", "--strides", "1", "--output", "run.csv", str(+number), when]
    surroundings = {"cwd": tmp_path, "env": {**os.environ, "TMPDIR": str(tmp_path / "temporary")}}
    done = run_python("-c", TERMINATED, *options, **surroundings)
    assert done.returncode == 128 + number and "Traceback" not in done.stderr, done.stderr
    assert list((tmp_path / "temporary").iterdir()) == []
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {"temporary"} | ({"run.csv"} if when == "in a file" else set())


@POSIX_ONLY
def test_a_pipe_among_figures_is_not_written_over(command, tmp_path):
    os.mkfifo(tmp_path / FIGURE)
    message = command.refusal(*FIGURES, tmp_path)
    assert "a pipe or device" in message
    assert (tmp_path / FIGURE).is_fifo()


def test_a_dataset_comes_back_as_it_was(command, tmp_path):
    """xarray itself reads the same dataset from the file."""
    assert command(*[str(word).replace("{}", "sweep") for word in NETCDF])[0] == 0
    xarray.testing.assert_identical(
        netcdf.read_dataset(tmp_path / "sweep.nc"), xarray.load_dataset(tmp_path / "sweep.nc")
    )
