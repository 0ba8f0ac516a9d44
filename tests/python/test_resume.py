"""Results on file: whole or in blocks that are done; only the same work is resumed."""

import json
from concurrent.futures import Executor, Future

import numpy as np
import pytest
import tdmf_slip
import xarray
from tdmf_slip import InputError, sweep
from tdmf_slip.analysis import sweeps as sweep_module
from tdmf_slip.blocks import InTurn
from tdmf_slip.files.resume import Resumed, refuse_resumable
from tdmf_slip.record import dataset

FRICTION, DAMPING = "ground.friction", "leg.damping"
VARY = {DAMPING: [0.2, 0.25, 0.3], FRICTION: [0.6, 0.5, 0.4]}


@pytest.fixture(scope="module")
def whole():
    return sweep(None, VARY)


@pytest.fixture
def half(tmp_path, monkeypatch):
    """A sweep on file that a fault of the code ended in its second row; and the rows searched since then."""
    honest, rows = sweep_module._row, []

    def stopping(runner, along, values):
        rows.append(runner[DAMPING])
        if len(rows) == 2:
            raise ValueError("a fault of the code")
        return honest(runner, along, values)

    monkeypatch.setattr(sweep_module, "_row", stopping)
    with pytest.raises(ValueError, match="a fault of the code"):
        sweep(None, VARY, path=tmp_path / "sweep.nc", executor=InTurn())
    rows[:] = ["resumed"] * 2
    return tmp_path / "sweep.nc", rows


def test_a_sweep_that_stopped_is_resumed(half, whole):
    path, rows = half
    assert not path.exists() and len(list((path.parent / "sweep.nc.parts").iterdir())) == 1
    gaits, borders = sweep(None, VARY, path=path)
    assert sorted(rows[2:]) == VARY[DAMPING][1:]
    assert gaits.identical(whole.gaits) and borders.identical(whole.borders)
    assert borders[FRICTION].size >= 3
    assert [file.name for file in path.parent.iterdir()] == ["sweep.nc"]
    again = sweep(None, VARY, path=path)
    assert len(rows) == 4 and again.gaits.identical(gaits) and again.borders.identical(borders)
    with xarray.open_dataset(path, group="borders") as read:
        assert read.load().equals(borders)


@pytest.mark.parametrize(
    ("runner", "vary", "why"),
    [
        ({"foot_mass": 0.11}, VARY, "another foot.mass"),
        (None, VARY | {FRICTION: [0.6, 0.5, 0.41]}, "other values of ground.friction"),
    ],
)
def test_other_work_is_not_resumed(half, runner, vary, why):
    path, rows = half
    with pytest.raises(InputError, match=rf"parts/\w+\.nc: not this sweep: {why}.*; give another file name"):
        sweep(runner, vary, path=path)
    tdmf_slip.sweep(None, VARY, path=path)
    with pytest.raises(InputError, match=rf"sweep\.nc: not this sweep: {why}"):
        sweep(runner, vary, path=path)
    with pytest.raises(InputError, match=r"without a variable period over ground\.friction, leg\.damping"):
        sweep(None, dict(reversed(VARY.items())), path=path)
    assert len(rows) == 4


@pytest.mark.parametrize(
    ("spoil", "why"),
    [
        (lambda data: data.drop_attrs(), "made by another program or an earlier version"),
        (lambda data: data.assign_attrs(version="0.0.9"), "another version"),
        (lambda data: data.assign_attrs(result="basin"), "holds a basin"),
        (lambda data: data.assign_attrs(runner="nobody"), "another runner"),
        (lambda data: data.assign_attrs(runner=3), "another runner"),
        (lambda data: data.drop_vars("speed"), "without a variable speed"),
        (lambda data: data.assign(speed=data["speed"].T), "without a variable speed"),
        (lambda data: data.drop_vars(DAMPING), f"other values of {DAMPING}"),
        (lambda data: data, "without a group borders"),
    ],
)
def test_a_file_of_something_else_is_refused_and_kept(whole, tmp_path, spoil, why):
    path = tmp_path / "sweep.nc"
    spoil(whole.gaits).to_netcdf(path)
    before = path.read_bytes()
    with pytest.raises(InputError, match=f"{why}.*; give another file name, or delete it to compute it anew"):
        sweep(None, VARY, path=path)
    assert path.read_bytes() == before


def test_a_block_without_its_place_is_refused(half):
    path, _ = half
    (part,) = (path.parent / "sweep.nc.parts").iterdir()
    data = xarray.load_dataset(part)
    assert json.loads(data.attrs.pop("place")) == {DAMPING: 0}
    for place in (None, "nothing", '{"leg.damping": 7}', '{"nosuch": 1}', "3"):
        data.assign_attrs({} if place is None else {"place": place}).to_netcdf(part)
        with pytest.raises(InputError, match="not this sweep: without its place"):
            sweep(None, VARY, path=path)


class LastFirst(Executor):
    """Runs each call but the first, which waits."""

    def __init__(self):
        self.futures = []

    def submit(self, fn, /, *args):
        self.futures.append(Future())
        if len(self.futures) > 1:
            self.futures[-1].set_result(fn(*args))
        return self.futures[-1]


def test_a_row_that_cannot_be_written_ends_the_others(monkeypatch):
    """The error ends them at once, also where it is kept, as a notebook does."""

    def failing(*_):
        raise OSError("no space left")

    monkeypatch.setattr(Resumed, "write", failing)
    executor = LastFirst()
    with pytest.raises(OSError, match="no space left") as kept:
        sweep(None, VARY, executor=executor)
    assert executor.futures[0].cancelled() and kept.value is not None


RECORD = {"version": "1", "model": "full", "runner": {}}


def blank(**attributes):
    return dataset("map", RECORD, {"a": ("x", np.full(4, np.nan))}, {"x": np.arange(4.0)}, **attributes)


def test_numbers_of_attributes_may_be_off_by_rounding(tmp_path):
    path = tmp_path / "map.nc"
    made = Resumed(path, blank(height=1.0), "map")
    made.write({"x": [0, 2]}, {"a": [1.0, 2.0]})
    assert Resumed(path, blank(height=1.0 + 1e-12), "map").done == [{"x": [0, 2]}]
    for height in (1.0 + 1e-8, "1.0", [1.0, 1.0]):
        with pytest.raises(InputError, match="another height"):
            Resumed(path, blank(height=height), "map")
    resumed = Resumed(path, blank(height=1.0), "map")
    resumed.write({"x": [1, 3]}, {"a": [3.0, 4.0]})
    assert resumed.data["a"].values.tolist() == [1.0, 3.0, 2.0, 4.0]


@pytest.mark.parametrize("content", [b"", b"rubbish", b"\x89HDF\r\n\x1a\n" + b"rubbish" * 100])
def test_a_file_that_is_no_netcdf_is_refused(tmp_path, content):
    path = tmp_path / "file.nc"
    path.write_bytes(content)
    with pytest.raises(InputError, match=r"file\.nc: not this map: no NetCDF file"):
        Resumed(path, blank(), "map")
    refuse_resumable(path)  # it may be written over


@pytest.mark.parametrize(
    ("kind", "over"),
    [("sweep", ("x", "y")), ("sweep", ("x",)), ("basin", ()), ("viability", ()), ("run", ())],
)
def test_long_results_are_not_written_over(tmp_path, kind, over):
    path = tmp_path / "file.nc"
    refuse_resumable(path)
    xarray.Dataset(attrs={"result": "sweep"}).to_netcdf(path)
    refuse_resumable(path)
    words = xarray.Dataset({"word": (over, np.full([2] * len(over), "+"))}, attrs={"result": kind})
    words.to_netcdf(path)
    if kind == "run" or over == ("x",):
        refuse_resumable(path)
    else:
        with pytest.raises(InputError, match=f"holds a {kind}"):
            refuse_resumable(path)


def test_a_file_where_the_folder_of_blocks_goes_is_refused_before_any_work(tmp_path):
    (tmp_path / "sweep.nc.parts").write_text("something else")
    with pytest.raises(InputError, match=r"sweep\.nc\.parts: cannot be written to"):
        sweep(None, {FRICTION: [0.6]}, path=tmp_path / "sweep.nc")
