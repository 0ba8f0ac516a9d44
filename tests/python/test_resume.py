"""Results on file are gone on with only where all that is in the file may be: anything else is refused."""

import numpy as np
import pytest
import xarray
from conftest import some_of
from tdmf_slip import InputError, Runner
from tdmf_slip.analysis import basin, grid
from tdmf_slip.files.resume import refuse_resumable, resumed, same_values
from tdmf_slip.library.gait import LEDGER
from tdmf_slip.library.quantities import STRIDE_QUANTITIES
from tdmf_slip.library.section import COORDINATES
from tdmf_slip.variables.table import VARIABLES

FRICTIONS = [0.6, 0.5]
DAMPINGS = [0.2, 0.25]
OVER = "leg.damping"


@pytest.fixture(scope="module")
def runner():
    return Runner({})


def make_grid(runner, path):
    return grid.grid(runner, {"ground.friction": FRICTIONS, OVER: DAMPINGS}, path)


@pytest.fixture(scope="module")
def whole(runner, tmp_path_factory):
    path = tmp_path_factory.mktemp("grid") / "grid.nc"
    make_grid(runner, path)
    return xarray.load_dataset(path)


@pytest.fixture
def half(whole):
    """The grid as it is after its first row."""
    half = whole.copy(deep=True)
    for name in half.data_vars:
        nothing = np.nan if half[name].dtype.kind == "f" else "" if half[name].dtype.kind in "OU" else 0
        half[name][1] = nothing
    return half


def test_a_half_done_grid_is_gone_on_with(runner, half, whole, tmp_path, monkeypatch):
    path = tmp_path / "grid.nc"
    half.to_netcdf(path)
    honest, rows = grid.gaits_of_row, []

    def noting(row):
        rows.append(row.runner[OVER])
        return honest(row)

    monkeypatch.setattr(grid, "gaits_of_row", noting)
    xarray.testing.assert_identical(make_grid(runner, path).drop_attrs(), whole.drop_attrs())
    assert rows == [DAMPINGS[1]]
    make_grid(runner, path)
    assert rows == [DAMPINGS[1]]


NUMBERS = (*STRIDE_QUANTITIES, *LEDGER, *(f"apex_{name}" for name in COORDINATES), "lambda_max")


def spoiled(data, name, value, row=0):
    data[name][{dim: (row, 0)[axis] for axis, dim in enumerate(data[name].dims)}] = value


def assert_refused(runner, data, path, match=r"grid\.nc: holds another sweep"):
    data.to_netcdf(path)
    before = path.read_bytes()
    with pytest.raises(InputError, match=match):
        make_grid(runner, path)
    assert path.read_bytes() == before


@pytest.mark.parametrize("name", NUMBERS)
def test_no_number_of_a_gait_is_believed(runner, half, tmp_path, name):
    """Where it is off by a hundred thousandth, and some, or with --release all, where it is quite another."""
    right = float(half[name][0, 0])
    largest = float(np.abs(half[name][0]).max())
    others = (123.0, np.nan, np.inf) if name in some_of(NUMBERS, 4) else ()
    for wrong in (right + 1e-5 * largest + 1e-12, *others):
        data = half.copy(deep=True)
        spoiled(data, name, wrong)
        assert_refused(runner, data, tmp_path / "grid.nc")


@pytest.mark.parametrize(
    ("name", "wrong", "row"),
    [
        ("done", 7, 0),
        ("done", -1, 0),
        ("done", 0, 0),
        ("done", 1, 1),
        ("done", 7, 1),
        ("word", "+0+", 0),
        ("word", "", 0),
        ("word", "+0-0+", 1),
        ("period", 123.0, 1),
        ("problem", "tired", 1),
    ],
)
def test_neither_are_marks_and_words(runner, half, tmp_path, name, wrong, row):
    spoiled(half, name, wrong, row)
    assert_refused(runner, half, tmp_path / "grid.nc")


def scaled(length):
    """The unit's own runner at so many times its length, with the same mass, stiffness and motion."""
    powers = {"m": 1, "m/s": 1, "m/s2": 1, "N.m": 2, "N.m/rad": 2, "N.m.s/rad": 2}
    own = Runner()
    return Runner(
        {name: value * length ** powers.get(VARIABLES[name].unit, 0) for name, value in own.items()}
    )


@pytest.mark.parametrize("length", [1.0, 1e3, 1e-3])
def test_what_is_rounding_goes_by_the_runners_length(tmp_path, length):
    """A rise that another machine rounds otherwise, and one that is none of level ground."""
    path = tmp_path / "grid.nc"
    grid.grid(scaled(length), {"ground.friction": [0.6], OVER: [0.2]}, path)
    whole = xarray.load_dataset(path)
    assert abs(whole["rise"].item()) < 1e-14 * length
    for off in (3e-13, -3e-13, 1e-12, -1e-12):
        data = whole.copy(deep=True)
        data["rise"][0, 0] += off * length
        data.to_netcdf(path)
        if abs(off) < 5e-13:
            grid.grid(scaled(length), {"ground.friction": [0.6], OVER: [0.2]}, path)
        else:
            with pytest.raises(InputError, match="holds another sweep"):
                grid.grid(scaled(length), {"ground.friction": [0.6], OVER: [0.2]}, path)


def test_a_gait_is_missing_only_with_a_reason(runner, half, tmp_path):
    for name in half.data_vars:
        if half[name].ndim == 2:
            half[name][0, 1] = "" if name == "word" else np.nan
    assert_refused(runner, half, tmp_path / "grid.nc")
    half["problem"][0] = "the runner was tired"
    half.to_netcdf(tmp_path / "grid.nc")
    assert make_grid(runner, tmp_path / "grid.nc")["period"].isnull().sum() == 1


@pytest.mark.parametrize(
    ("spoil", "match"),
    [
        (
            lambda data: data.attrs.update({"body.mass": data.attrs["body.mass"] * (1 + 1e-8)}),
            "another body.mass",
        ),
        (lambda data: data.attrs.update({"leg.angle": data.attrs["leg.angle"] + 1e-8}), "another leg.angle"),
        (lambda data: data.attrs.update({"body.mass": "1"}), "another body.mass"),
        (lambda data: data.attrs.update({"body.mass": [1.0, 2.0]}), "another body.mass"),
        (lambda data: data.attrs.update({"body.mass": ["a", "b"]}), "another body.mass"),
        (lambda data: data.attrs.pop("body.mass"), "another body.mass"),
        (lambda data: data.attrs.update({"version": "0.0.9"}), "another version"),
        (lambda data: data.attrs.update({"version": 1.0}), "another version"),
        (lambda data: data["period"].attrs.update({"units": "ms"}), "another units of period"),
        (lambda data: data[OVER].attrs.pop("units"), f"another units of {OVER}"),
    ],
)
def test_a_grid_with_other_attributes_is_another(runner, half, tmp_path, spoil, match):
    spoil(half)
    assert_refused(runner, half, tmp_path / "grid.nc", match)


@pytest.mark.parametrize(
    ("spoil", "match"),
    [
        (lambda data: data.drop_vars("speed"), "without such a variable speed"),
        (lambda data: data.rename({"speed": "pace"}), "without such a variable speed"),
        (lambda data: data.assign(speed=data["speed"].T), "without such a variable speed"),
        (lambda data: data.assign(done=data["done"] * 1.0), "without such a variable done"),
        (lambda data: data.assign_coords({OVER: [0.2, 0.26]}), f"other values of {OVER}"),
        (lambda data: data.drop_vars(OVER), f"other values of {OVER}"),
    ],
)
def test_a_grid_with_other_variables_is_another(runner, half, tmp_path, spoil, match):
    assert_refused(runner, spoil(half), tmp_path / "grid.nc", match)


def test_attributes_may_be_off_by_rounding(runner, half, tmp_path):
    half.attrs["body.mass"] *= 1 + 1e-12
    half["period"][0, 0] *= 1 + 1e-11
    half.to_netcdf(tmp_path / "grid.nc")
    assert make_grid(runner, tmp_path / "grid.nc")["done"].all()


@pytest.mark.parametrize("content", [b"", b"rubbish", b"\x89HDF\r\n\x1a\n" + b"rubbish" * 100])
def test_what_is_no_netcdf_file_is_told(tmp_path, content):
    path = tmp_path / "file.nc"
    path.write_bytes(content)
    with pytest.raises(InputError, match=r"file\.nc: no slice to go on with \(.+\); allowed: another"):
        resumed(path, xarray.Dataset(), "slice")
    refuse_resumable(path)  # it may be written over


def test_a_file_that_is_not_there_yet_is_no_trouble(tmp_path):
    blank = xarray.Dataset({"a": ("x", [1.0])})
    assert resumed(tmp_path / "none.nc", blank, "slice") is blank
    refuse_resumable(tmp_path / "none.nc")


@pytest.mark.parametrize(("name", "what"), [("done", "a grid of gaits"), ("fate", "a map"), ("speed", None)])
def test_what_took_long_is_not_written_over(tmp_path, name, what):
    path = tmp_path / "file.nc"
    xarray.Dataset({name: ("x", [1])}).to_netcdf(path)
    if what is None:
        refuse_resumable(path)
    else:
        with pytest.raises(InputError, match=f"holds {what}"):
            refuse_resumable(path)


def test_values_are_the_same_to_a_part_of_the_largest():
    one = xarray.Dataset({"a": ("x", [0.0, 100.0, np.nan]), "b": ("x", ["p", "q", "r"])})
    other = one.copy(deep=True)
    assert same_values(one, other)
    other["a"][0] = 1e-3
    assert not same_values(one, other) and same_values(one, other, 2e-5) and not same_values(one, other, 5e-6)
    other["a"][0] = np.nan
    assert not same_values(one, other, 1.0) and not same_values(other, one, 1.0)
    other = one.copy(deep=True)
    other["b"][1] = "o"
    assert not same_values(one, other, 1.0)


def settled_map(runner, path):
    values = {"com_height": [1.4, 1.41], "com_speed": [1.0]}
    return basin.basin_at(basin.stable_gait(runner), values, path=path)


@pytest.mark.parametrize(
    ("fate", "strides"),
    [(-1, 401), (0, -1), (0, 401), (1, -1), (1, 401), (2, 401), (3, 1), (9, 5), (-2, 0), (77, 1)],
)
def test_a_map_with_fates_or_strides_that_cannot_be_is_refused(runner, tmp_path, fate, strides):
    path = tmp_path / "map.nc"
    data = settled_map(runner, path).to_xarray()
    data["fate"][1, 0], data["strides_until_known"][1, 0] = fate, strides
    data.to_netcdf(path)
    with pytest.raises(InputError, match=rf"row 1, column 0 with fate {fate} after {strides} strides"):
        settled_map(runner, path)


@pytest.mark.parametrize(
    "attributes", [{"flag_meanings": "fell settled undecided no_start"}, {"flag_values": [3, 2, 1, 0]}]
)
def test_a_map_that_calls_fates_otherwise_is_refused(runner, tmp_path, attributes):
    path = tmp_path / "map.nc"
    data = settled_map(runner, path).to_xarray()
    data["fate"].attrs |= attributes
    data.to_netcdf(path)
    with pytest.raises(InputError, match=f"another {next(iter(attributes))} of fate"):
        settled_map(runner, path)
