"""Swing-leg retraction: what its rate does to the gaits, found by the branch and seen in runs."""

import numpy as np
import pytest
from conftest import CLAMPED
from tdmf_slip import Batch, Runner, continue_branch, gait_at
from tdmf_slip.analysis.special_points import PERIOD_DOUBLING
from tdmf_slip.paper.along import gait_table

RATE = "hip.retraction_rate"


@pytest.fixture(scope="module")
def branch():
    """Branch with the clamp, where gaits of two strides last; without it they are soon lost."""
    runner = Runner({"ground.friction": 0.2, **CLAMPED})
    return continue_branch(runner, {RATE: (0.0, 0.01)}, switch=False)


def heights(runner, apex):
    """Apex heights of four strides, after many others."""
    ends = Batch(runner, apex[None]).run(1000)
    found = []
    for _ in range(4):
        ends = Batch(runner, ends.apex).run(1)
        found.append(ends["apex"][0, 0])
    return np.array(found)


def test_beyond_the_period_doubling_strides_alternate(branch):
    (doubling,) = branch[RATE].values[branch["special"] == PERIOD_DOUBLING]
    gait = gait_at(branch.isel(point=0))
    once = heights(gait.runner.replace({RATE: 0.9 * doubling}), gait.apex)
    twice = heights(gait.runner.replace({RATE: 1.2 * doubling}), gait.apex)
    np.testing.assert_allclose(once, once[0], rtol=1e-7)
    np.testing.assert_allclose(twice[2:], twice[:2], rtol=1e-7)
    assert abs(twice[1] - twice[0]) > 0.05


def test_leading_eigenvalues_keep_their_signs(branch):
    rows = gait_table(branch)
    greater, other = (
        rows.loc[rows["special"] == "", f"{of}_eigenvalue"].values for of in ("greater", "other")
    )
    assert (greater > 0.9).all()
    assert (np.diff(other) < 0.0).all()
    assert other[-1] < -1.0 < other[0]
