"""Falls on a slippery patch, as guinea fowl fall: the map, and what is published beside it."""

import numpy as np
import pytest
from tdmf_slip import RunError
from tdmf_slip.library.strides import plain_stride, strides_from
from tdmf_slip.paper import guinea_fowl
from tdmf_slip.paper.guinea_fowl import AFTER, borders, contact_angle_of, gaits, landing_at, meet_patch


@pytest.fixture(scope="module")
def found():
    return guinea_fowl.fall_map()


def stays_up(gait, angle, friction):
    """The native solver runs stride by stride."""
    patch, apex = landing_at(gait, angle).replace({"ground.friction": friction}), gait.apex
    try:
        for runner in (patch, *[gait.runner] * AFTER):
            apex = apex + plain_stride(runner, apex, []).residual
    except RunError:
        return False
    return True


def test_gaits_have_the_speeds_that_are_published(found):
    assert found["speed"].values == pytest.approx(np.arange(1.4, 3.65, 0.1), rel=1e-9)
    assert all(gait.stable for gait in gaits())


def test_the_leg_comes_down_at_the_angle_that_is_asked_for(found):
    for gait in gaits()[::6]:
        for angle in (60.0, 64.0):
            landed = strides_from(landing_at(gait, angle), gait.apex)
            assert contact_angle_of(landed) == pytest.approx(angle, abs=1e-9)
    assert landing_at(gaits()[-1], 80.0) is None and landing_at(gaits()[-1], 30.0) is None


def test_a_patch_that_is_none_changes_nothing(found):
    gait = gaits()[10]
    outcomes = meet_patch([gait], [contact_angle_of(gait)], [gait.friction])
    assert outcomes["fell"].item() == 0.0
    assert outcomes["slip_distance"].item() == pytest.approx(gait.stride["slip_distance"], abs=1e-12)


@pytest.mark.parametrize("friction", [0.05, 2.0])
def test_the_native_solver_sees_the_same_falls(found, friction):
    fell = found["fell"].sel(friction=friction).values
    compared = {True: 0, False: 0}
    for row in range(0, len(gaits()), 4):
        for column in range(0, len(guinea_fowl.ANGLES), 5):
            if np.isfinite(fell[row, column]):
                up = stays_up(gaits()[row], guinea_fowl.ANGLES[column], friction)
                assert up == (fell[row, column] == 0.0), (row, column)
                compared[up] += 1
    assert min(compared.values()) >= 3


def test_what_is_published_is_read_from_its_file():
    said = guinea_fowl.published()["published"]
    assert (said["slowest"], said["fastest"], said["fast"]) == (1.3, 3.6, 3.0)
    assert (said["contact_angle"], said["slip_distance"]) == (70.0, 0.10) and len(said) == 5


def test_what_is_published_stands_beside_what_is_computed(found):
    """Agreement and difference with their map: the border is near 70 degrees, and lower for fast runners."""
    verdicts = [claim.verdict for claim in guinea_fowl.claims(found)]
    assert verdicts == ["differs", "agrees", "differs", "agrees", "differs", "differs"]
    border = borders(found, 0.05)
    assert (border[0], np.max(border), border[-1]) == (67.0, 67.0, 61.0)
    assert np.all(border >= borders(found, 2.0))


def test_a_shorter_leg_hardly_moves_the_border():
    """The numbers of the guide."""
    shorter = guinea_fowl.fall_map(0.15)
    assert borders(shorter, 0.05)[[0, -1]].tolist() == [67.0, 59.0]
    assert shorter["speed"].values[[0, -1]] == pytest.approx([1.3, 3.6], abs=0.05)
