"""What a notebook shows of a result: a line, a picture, and a dataset over the time or the parameter."""

from xml.etree import ElementTree

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.pictures.plot import plot


@pytest.fixture(scope="module")
def results():
    gait = tdmf_slip.find_gait({"ground.friction": 0.6})
    return {
        "run": tdmf_slip.simulate({"ground.friction": 0.43}, strides=2),
        "gait": gait,
        "sweep": tdmf_slip.sweep({}, {"ground.friction": [0.7, 0.6, 0.45, 0.43]}),
        "branch": tdmf_slip.continue_branch(gait, {"leg.damping": (0.2, 0.22)}),
    }


def curves(figure):
    return [line.get_xydata() for axes in figure.axes for line in axes.lines]


def assert_shows(figure, x, y):
    wanted = np.column_stack([x, y])
    assert any(curve.shape == wanted.shape and np.array_equal(curve, wanted) for curve in curves(figure))


def test_each_has_a_picture_of_what_it_holds(results):
    run, sweep, branch = results["run"], results["sweep"], results["branch"]
    assert_shows(plot(run), run["time"], run["contact.fy"])
    assert_shows(plot(sweep), sweep.gaits["ground.friction"], sweep.gaits["speed"])
    assert_shows(plot(branch), branch["leg.damping"], branch["lambda_max"])
    edges = {tuple(curve[:, 1]) for curve in curves(results["gait"].plot()) if len(curve) == 2}
    assert {(0.6, 0.6), (-0.6, -0.6)} <= edges  # the friction cone's


def test_a_picture_is_shown_once(results):
    """A notebook shows what a cell gives, and every figure that is still open."""
    import matplotlib.pyplot as plt

    before = plt.get_fignums()
    assert results["gait"].plot().axes
    assert plt.get_fignums() == before


def test_a_run_is_a_dataset_over_the_time(results):
    run = results["run"]
    assert set(run.sizes) == {"time", "event"} and {"time", "event"} <= set(run.coords)
    assert run["time"].attrs["units"] == "s" and run["leg.length"].attrs["units"] == "m"
    # At an apex there are two rows of the same time: both are found by it.
    apex = run.sel(time=run.attrs["apex.time"])
    assert apex["com.vy"].shape == (2,) and np.abs(apex["com.vy"]).max() < 1e-9


def test_so_is_the_file_that_the_command_writes(results, command, tmp_path):
    import xarray

    options = ("--friction", "0.43", "--strides", "2", "--output", "run.nc")
    assert command("simulate", *options)[0] == 0
    with xarray.open_dataset(tmp_path / "run.nc", decode_times=False) as data:
        expected = results["run"]
        assert set(data.coords) == set(expected.coords) and set(data.data_vars) == set(expected.data_vars)
        assert np.array_equal(data["contact.fx"], expected["contact.fx"])


def test_gaits_are_a_dataset_over_their_parameter(results):
    sweep, branch = results["sweep"].gaits, results["branch"]
    assert list(sweep["word"].values) == ["+0-0+", "+0-0+", "+0-", "+0-"]
    gait = tdmf_slip.gait_at(branch.isel(point=-1))
    assert branch["lambda_max"].values[-1] == pytest.approx(gait.lambda_max, rel=1e-9)
    assert branch["leg.damping"].values[-1] == gait.runner["leg.damping"] == 0.22


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_the_box_of_a_gait_has_eight_rows_and_a_mark_for_each_eigenvalue(model):
    gait = tdmf_slip.find_gait("human", model=model)
    box = gait._repr_html_()
    table, picture = box.split("</table>")
    assert table.count("<tr>") == 8 and f"<td>{gait.speed:.6g} m/s</td>" in table and "stable" in table
    marks = [
        (mark.get("cx"), mark.get("cy"))
        for mark in ElementTree.fromstring(picture).iter("circle")
        if mark.get("cx")
    ]
    found = sorted((float(x), -float(y)) for x, y in marks)
    wanted = sorted((value.real, value.imag) for value in gait.eigenvalues.astype(complex))
    np.testing.assert_allclose(found, wanted, atol=1e-4)
