"""Laws from apex to settings: the Jacobian under a law, its noise, and laws that are refused."""

import dataclasses
import re

import numpy as np
import pytest
from conftest import CLAMPED
from tdmf_slip import AffineLaw, InputError, Runner, basin, find_gait, strides_to_fall
from tdmf_slip.analysis.attraction import attraction_volume, robustness
from tdmf_slip.analysis.ball import check_attracts, fates, jacobian_under
from tdmf_slip.library.return_map import stride_from

ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
NAMES = (ANGLE, TORQUE)


@pytest.fixture(scope="module")
def gait():
    """Gait with the clamp of the swing."""
    return find_gait(Runner({"ground.friction": 0.6, **CLAMPED}))


@pytest.fixture(scope="module")
def nothing(gait):
    """A law that sets what the runner has."""
    usual = [gait.runner[name] for name in NAMES]
    return AffineLaw(NAMES, gait.apex, usual, np.zeros((2, 6)), usual, usual)


@pytest.fixture(scope="module")
def settling(gait):
    """Law that brings the next apex as near to the gait's as two settings can, by least squares."""
    usual = np.array([gait.runner[name] for name in NAMES])
    by_settings = np.array([stride_from(gait.runner, gait.apex, name)[2] for name in NAMES]).T
    over = 1.0 / gait.runner.scales[:, None]
    gain = -np.linalg.lstsq(over * by_settings, over * gait.jacobian, rcond=None)[0]
    return AffineLaw(NAMES, gait.apex, usual, gain, usual * 0.8, usual * 1.2)


def test_the_jacobian_under_a_law_is_that_of_differences(gait, settling):
    jacobian = jacobian_under(gait, settling)
    values = gait.runner

    def following(apex):
        runner = Runner(dict(values) | settling.inputs_at(apex))
        return stride_from(runner, apex, ANGLE)[0]

    step = 1e-5
    for k in range(6):
        change = step * np.eye(6)[k]
        slope = (following(gait.apex + change) - following(gait.apex - change)) / (2.0 * step)
        np.testing.assert_allclose(jacobian[:, k], slope, atol=1e-5)
    assert np.abs(np.linalg.eigvals(jacobian)).max() < 0.5 * gait.lambda_max


def test_noise_is_drawn_by_the_number_in_the_slice(gait, settling):
    noisy = dataclasses.replace(settling, noise=[0.01] * 6)
    axes, n = {"com_height": (0.9, 2.4), "com_speed": (0.2, 2.3)}, (6, 5)
    found = basin(gait.runner, axes, n, law=noisy)
    starts = np.tile(gait.apex, (30, 1))
    ranges = [np.linspace(*ends, count) for ends, count in zip(axes.values(), n, strict=True)]
    starts[:, 0], starts[:, 1] = (grid.ravel() for grid in np.meshgrid(*ranges, indexing="ij"))
    by_number = fates(gait, starts, law=noisy)
    np.testing.assert_array_equal(found["fate"].values.ravel(), by_number["fate"])
    np.testing.assert_array_equal(found["strides_until_known"].values.ravel(), by_number["strides"])


def test_laws_that_do_not_keep_the_gait_are_told(gait, nothing):
    def refused(message, law):
        for judge in (
            lambda: check_attracts(gait, law),
            lambda: robustness(gait, law),
            lambda: attraction_volume(gait, 10, law=law),
        ):
            with pytest.raises(InputError, match=re.escape(message)):
                judge()

    usual = gait.runner[ANGLE]
    elsewhere = AffineLaw([ANGLE], gait.apex, [usual + 0.01], [[0] * 6], [0], [1])
    refused(
        "law: hip.touchdown_angle = 0.708132 at the gait's apex, where the runner has 0.698132", elsewhere
    )
    wild = AffineLaw([ANGLE], gait.apex, [usual], [[3, 0, 0, 0, 0, 0]], [0], [1])
    refused("law: under it the gait at friction 0.6 is unstable, with a largest eigenvalue of", wild)
    refused("law = 1 is not allowed; allowed: a function of apices and", 1)
    reduced = find_gait({"ground.friction": 0.6}, model="reduced")
    with pytest.raises(
        InputError, match="law: has 6 coordinates; allowed: those of the runner, com_height, com_speed"
    ):
        robustness(reduced, nothing)
    with pytest.raises(InputError, match="law = 'stiff' is not allowed"):
        strides_to_fall(gait.runner, 0.1, law="stiff", gait=gait)
