"""Where searches begin: runners all over a box that settle, and which of them have no better one near."""

import numpy as np
import pytest
from tdmf_slip import Runner, find_gait
from tdmf_slip.analysis.settled import evenly, linked, settled_gaits
from tdmf_slip.library.fixed_point import gait_near

NAMES = ("hip.touchdown_angle", "hip.stance_torque")
RANGES = dict(zip(NAMES, np.array([[0.4, 0.9], [0.05, 0.5]]), strict=True))


def test_each_basin_of_a_wavy_function_is_begun_in():
    """cos 4 pi x cos 4 pi y has its least, -1, at twelve points of the square, all but four on its edges."""
    points = evenly(2000, 2)
    merits = np.prod(np.cos(4.0 * np.pi * points), axis=1)
    begun = points[list(linked(points, merits))]
    grid = [(x, y) for x in np.arange(5) / 4.0 for y in np.arange(5) / 4.0]
    least = [point for point in grid if np.prod(np.cos(4.0 * np.pi * np.array(point))) < -0.9]
    assert len(least) == 12
    for point in least:
        assert np.min(np.linalg.norm(begun - point, axis=1)) < 0.05
    assert len(begun) < 40


def test_one_basin_is_begun_in_once():
    points = evenly(500, 3)
    begun = linked(points, np.sum((points - 0.4) ** 2, axis=1))
    assert len(begun) == 1
    assert linked(points[:0], np.zeros(0)) == []


@pytest.mark.parametrize("dimension", [1, 2, 5])
def test_points_fill_a_box_evenly(dimension):
    """Each half of each side has half of them."""
    points = evenly(1000, dimension)
    assert np.all((points >= 0.0) & (points < 1.0))
    assert np.mean(points < 0.5, axis=0) == pytest.approx(0.5, abs=0.01)
    assert np.array_equal(evenly(10, dimension, 990), points[990:])


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_runners_that_settle_are_next_to_their_gaits(model):
    first = find_gait({"ground.friction": 0.3}, model=model)
    found = settled_gaits(first, NAMES, lambda name, shares: RANGES[name] @ [1.0 - shares, shares])
    assert 400 < len(found.runners) < 1024
    for runner, point, apex in list(zip(found.runners, found.points, found.apexes, strict=True))[::50]:
        values = [RANGES[name] @ [1.0 - share, share] for name, share in zip(NAMES, point, strict=True)]
        assert [runner[name] for name in NAMES] == pytest.approx(values, rel=1e-15)
        gait = gait_near(runner, apex)
        assert np.max(np.abs((gait.apex - apex) / runner.scales)) < 0.02
        assert gait.lambda_max < 1.0


def test_runners_whose_values_do_not_go_together_are_left_out():
    first = find_gait({})
    found = settled_gaits(first, ["leg.free_length"], lambda _, shares: np.where(shares < 0.99, 0.02, 1.0))
    assert len(found.runners) == np.count_nonzero(evenly(1024, 1) >= 0.99) > 5
    assert {runner["leg.free_length"] for runner in found.runners} == {1.0}


def test_every_unit_of_the_fmu_has_its_dimensions(fmu):
    """Scales of the library's own, made in C, are those that the table of dimensions gives."""
    runner = Runner({"leg.free_length": 2.0, "body.mass": 9.0, "leg.stiffness": 4.0, "leg.length": 2.0})
    units = {variable.unit or "1" for variable in fmu.variables.values()}
    assert len(units) > 10
    assert all(runner.scale_of(unit) > 0.0 for unit in units)
    scales = runner.c_model.scales
    for unit, scale in (("m/s", scales.speed), ("N", scales.force), ("J", scales.energy)):
        assert runner.scale_of(unit) == pytest.approx(scale, rel=1e-15)
    of_section = [runner.scale_of(fmu.variables[f"apex.{name}"].unit) for name in runner.coordinates]
    assert of_section == pytest.approx(runner.scales, rel=1e-15)
