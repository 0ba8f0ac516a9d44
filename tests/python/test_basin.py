"""Regions of attraction: fates agree with runs of the unit, on any executor, and none is lost."""

import numpy as np
import pytest
import xarray
from matplotlib import pyplot as plt
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from tdmf_slip import InputError, Runner
from tdmf_slip.analysis import basin
from tdmf_slip.blocks import InTurn
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.library import engine, section
from tdmf_slip.pictures import basin_map

AXES = {"com_height": (1.2, 2.9), "com_speed": (0.9, 1.6)}
N = 12, 9
VALUES = {name: np.linspace(*ends, n) for (name, ends), n in zip(AXES.items(), N, strict=True)}


@pytest.fixture(scope="module")
def slice_(runner):
    return basin.basin(runner, AXES, N)


def test_fates_are_those_of_runs_through_the_unit(slice_):
    """CVODE in Model Exchange falls from where the map says so, after as many strides."""
    fallen = np.argwhere(slice_["fate"].values == 1)
    settled = np.argwhere(slice_["fate"].values == 0)
    assert len(fallen) >= 2 and len(settled) > len(fallen)
    for row, column in (fallen[0], settled[0]):
        apex = [slice_.attrs[f"gait_{name}"] for name in section.COORDINATES]
        apex[0], apex[1] = VALUES["com_height"][row], VALUES["com_speed"][column]
        run = run_unit(Runner({}).state_at(apex), strides=30, tolerance=1e-9)
        assert run.fallen == (slice_["fate"][row, column] == 1)
        if run.fallen:
            assert run.stride["count"] == slice_["strides_until_known"][row, column]
        else:
            assert run.stride["word"] == slice_.attrs["word"]


def test_a_part_of_a_map_is_that_of_the_whole(runner, slice_):
    axes = {"com_height": VALUES["com_height"][3:5], "com_speed": VALUES["com_speed"][[1, -1]]}
    part = basin.basin(runner, axes, (2, N[1] - 1))
    np.testing.assert_array_equal(part["strides_until_known"], slice_["strides_until_known"][3:5, 1:])


def test_a_map_is_gone_on_with(runner, slice_, tmp_path, monkeypatch):
    path = tmp_path / "map.nc"
    honest, calls = basin.Slice.fates, []

    def interrupted(self, block):
        calls.append(len(block[0]) // N[1])
        if len(calls) == 2:
            raise KeyboardInterrupt
        return honest(self, block)

    monkeypatch.setattr(basin, "STARTS_AT_ONCE", 8 * N[1])
    monkeypatch.setattr(basin.Slice, "fates", interrupted)
    with pytest.raises(KeyboardInterrupt):
        basin.basin(runner, AXES, N, path=path, executor=InTurn())
    whole = basin.basin(runner, AXES, N, path=path, executor=InTurn())
    assert calls == [8, 4, 4]  # the block that was done is not done twice
    on_file = xarray.load_dataset(path)
    xarray.testing.assert_equal(on_file, slice_)
    assert on_file.attrs["settled_share"] == whole.settled_share
    assert list(tmp_path.iterdir()) == [path]  # the blocks are gone
    xarray.testing.assert_equal(basin.basin(runner, AXES, N, path=path), whole)
    assert len(calls) == 3
    with pytest.raises(InputError, match="not this map of fates: other values of com_height"):
        basin.basin(runner, {**AXES, "com_height": (1.3, 3.0)}, N, path=path)


def test_without_ranges_a_map_is_around_the_gait(runner):
    found = basin.basin(runner, n=3)
    gait = basin.stable_gait(runner)
    for name in AXES:
        assert (found[name][0], found[name][-1]) == basin.range_around(gait, name)


def test_basin_command(command):
    options = ("--n", 4, "--axes", "com_height=1.3:1.5", "--axes", "com_speed=1.0:1.1", "--samples", 200)
    found = command.json("basin", *options, "--output", "map.nc", "--plot", "map.png")
    assert (found["starts"], found["settled"]) == (16, 16)
    assert found["robustness"]["push_backward"] is None  # beyond the largest tried
    assert found["settled_area"] == pytest.approx(0.2 * 0.1)
    low, high = found["volume"]["share_interval"]
    assert 0.6 < low < found["volume"]["share"] < high < 0.95
    status, out, _ = command("basin", "--parameters", "human", "--n", 4, "--samples", 200)
    assert status == 0 and "95 % confidence" in out
    assert command("basin", "--axes", "com_height", "--axes", "height")[0] == 2
    assert command("basin", "--n", 0)[0] == 2


def drawn(data):
    """The figure of a map as pixels, with its axes."""
    figure = basin_map.figure_of(data)
    plt.close(figure)
    figure.set_dpi(basin_map.style.DOTS_PER_INCH)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3], figure.axes[0], figure


def pixels_near(pixels, axes, at, colour):
    """Number of pixels of a colour within 12 of a point of the map."""
    across, up = axes.transData.transform(at)
    row, column = pixels.shape[0] - round(up), round(across)
    part = pixels[row - 12 : row + 12, column - 12 : column + 12].astype(float)
    return int((np.abs(part - 255.0 * np.array(to_rgb(colour))).max(axis=-1) < 8).sum())


def map_of(slice_, size, fate, strides):
    """A map of any size, of a gait and axes that are real."""
    along = {"com_height": np.linspace(1.0, 2.0, size), "com_speed": np.linspace(0.5, 1.5, size)}
    fates = np.full((size, size), fate, dtype="i4")
    data = xarray.Dataset(
        {
            "fate": (tuple(AXES), fates),
            "strides_until_known": (tuple(AXES), np.full_like(fates, strides)),
        },
        {name: (name, values, slice_[name].attrs) for name, values in along.items()},
        slice_.attrs,
    )
    data["strides_until_known"][0, 0] = 100
    return data


@pytest.mark.parametrize(("size", "around", "strides"), [(5, 0, 100), (64, 1, 3), (256, 1, 100)])
def test_a_single_start_of_another_fate_is_seen(slice_, size, around, strides):
    """One map has a start of each of three other fates."""
    data = map_of(slice_, size, around, strides)
    low, high = size // 4, size // 2 + size // 4
    places = {"undecided": (high, high), "no_start": (low, high), "unsolved": (high, low)}
    for name, (row, column) in places.items():
        data["fate"][row, column] = engine.FATES.index(name)
    pixels, axes, _ = drawn(data)
    for name, (row, column) in places.items():
        at = data["com_speed"][column], data["com_height"][row]
        assert pixels_near(pixels, axes, at, basin_map.OTHERS[name][0]) >= 30, name


@pytest.mark.parametrize(
    ("fate", "strides"), [(0, 0), (0, 100), *((k, 0) for k in range(1, len(engine.FATES)))]
)
def test_the_gait_is_seen_on_any_colour(slice_, fate, strides):
    pixels, axes, _ = drawn(map_of(slice_, 32, fate, strides))
    at = slice_.attrs["gait_com_speed"], slice_.attrs["gait_com_height"]
    assert pixels_near(pixels, axes, at, basin_map.style.INK) >= 40
    assert pixels_near(pixels, axes, at, "white") >= 40


@pytest.mark.parametrize(
    ("preset", "length", "rate"),
    [
        ("paper", "leg length (l₀)", "rate of leg angle (√(k/m))"),
        ("human", "leg length (m;  l₀ = 1 m)", "rate of leg angle (rad/s;  √(k/m) = 16.52 rad/s)"),
    ],
)
def test_a_map_says_friction_and_units(preset, length, rate):
    """The paper's units for a runner in them; SI with the runner's scales for any other."""
    runner = Runner(preset).replace({"ground.friction": 0.55})
    data = basin.basin(runner, {"leg_length": (1.2, 1.3), "leg_angle_rate": (0.2, 0.4)}, 2)
    _, axes, figure = drawn(data)
    assert "friction 0.55" in axes.get_title()
    assert (axes.get_ylabel(), axes.get_xlabel()) == (length, rate)
    assert "beyond the map" in figure.legends[0].get_texts()[0].get_text()


def test_a_reversed_range_is_the_same_map(slice_):
    there, axes, _ = drawn(slice_)
    back, reversed_axes, _ = drawn(slice_.isel(com_height=slice(None, None, -1)))
    assert axes.get_ylim() == reversed_axes.get_ylim()
    np.testing.assert_array_equal(there, back)
    assert set(engine.FATES) == {*basin_map.COUNTED, *basin_map.OTHERS}
