"""Every analysis takes every law: a function that sets what an affine law sets gives the same result."""

import dataclasses

import numpy as np
import pytest
import tdmf_slip
from conftest import assert_same
from tdmf_slip import (
    Batch,
    InputError,
    RoughGround,
    basin,
    find_gait,
    lqr,
    rare_falls,
    strides_to_fall,
)
from tdmf_slip.analysis.attraction import attraction_volume, robustness
from tdmf_slip.library.engine import FELL
from tdmf_slip.record import runner_in

ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
AXES = {"com_height": (0.9, 2.4), "com_speed": (0.3, 1.8)}


@pytest.fixture(scope="module")
def affine(gait):
    return lqr(gait, [ANGLE, TORQUE], limits={ANGLE: (0.4, 1.0), TORQUE: (0.1, 0.3)})


class Function:
    """An affine law as a function: the engine does not see that it is one."""

    def __init__(self, law):
        self.law = law

    def __call__(self, apices, stride_number):
        return self.law(apices, stride_number)


@pytest.mark.parametrize(
    "analysis",
    [
        lambda gait, law: strides_to_fall(gait, 0.6, 80, 1, 40, gait=gait, law=law),
        lambda gait, law: strides_to_fall(
            gait, RoughGround(0.3, 2, trips=True, step_weights=(0.8, 0.6)), 60, max_strides=40, law=law
        ),
        lambda gait, law: rare_falls(gait, 0.5, walkers=8, strides=8, gait=gait, law=law),
        lambda gait, law: attraction_volume(gait, 200, law=law, ball="none"),
    ],
    ids=["strides to fall", "on ground that trips", "rare falls", "volume"],
)
def test_an_analysis_gives_the_same_by_a_function(gait, affine, analysis):
    assert_same(analysis(gait, Function(affine)), analysis(gait, affine))


def test_maps_and_judgements_are_the_same_by_a_function(gait, affine):
    one, other = (basin(gait, AXES, (7, 8), law=law, ball="none") for law in (affine, Function(affine)))
    np.testing.assert_array_equal(one["fate"], other["fate"])
    np.testing.assert_array_equal(one["strides_until_known"], other["strides_until_known"])
    assert other.attrs["law"].startswith("Function, check sum of settings ")
    assert robustness(gait, Function(affine)) == robustness(gait, affine)


def test_a_file_of_a_map_is_not_gone_on_with_under_another_function(gait, affine, tmp_path):
    path = tmp_path / "map.nc"
    basin(gait, AXES, 3, law=Function(affine), path=path)
    weaker = dataclasses.replace(affine, gain=0.9 * np.array(affine.gain))
    with pytest.raises(InputError, match="another law"):
        basin(gait, AXES, 3, law=Function(weaker), path=path)


def test_under_a_function_the_gait_is_the_one_that_it_keeps():
    """A constant torque of its own: the map is that of the gait with this torque."""
    own = find_gait(friction=0.6, torque=0.22)
    by_law = basin({"ground.friction": 0.6}, AXES, 4, law=lambda apices, _: {TORQUE: 0.22}, ball="none")
    alone = basin(own, AXES, 4, ball="none")
    np.testing.assert_array_equal(by_law["fate"], alone["fate"])
    assert runner_in(by_law)[TORQUE] == 0.22
    with pytest.raises(InputError, match="at the gait's apex, where the runner has"):
        basin(
            {"ground.friction": 0.6},
            AXES,
            2,
            law=lambda apices, _: {TORQUE: np.where(apices[:, 1] > 1.06, 0.15, 0.25)},
        )


def test_a_function_that_destabilizes_the_gait_is_refused(gait):
    law = lambda apices, _: {ANGLE: 0.698131700797732 + 3.0 * (apices[:, 0] - gait.apex[0])}  # noqa: E731
    with pytest.raises(InputError, match=r"under it the gait at friction 0\.6 is unstable"):
        basin(gait, AXES, 2, law=law)


def test_the_viable_controller_is_tested_for_falls():
    """Runners fall as they do if the controller's settings are given to steps in place, one by one."""
    runner, gait = {"ground.friction": 0.6}, find_gait(friction=0.6)
    found = tdmf_slip.viability(
        runner,
        axes={"com_height": (0.9, 2.4), "com_speed": (0.3, 1.8)},
        vary={ANGLE: (0.3, 1.1, 12), TORQUE: (0.05, 0.4, 6)},
        n=16,
    )
    law = tdmf_slip.ViableController(found)
    passage = strides_to_fall(runner, 0.6, 50, 1, 12, law=law)
    batch = Batch(gait, np.tile(gait.apex, (50, 1)), RoughGround(0.6, 1), tolerance=1e-5)
    runs, strides = np.full(50, True), 0
    for _ in range(12):
        strides += np.count_nonzero(runs)
        runs = batch.step(law(batch.apices)) != FELL
    assert 0 < passage.falls == np.count_nonzero(~runs) < 50
    assert passage.strides == strides
    assert rare_falls(runner, 0.5, walkers=8, strides=16, law=law).falls > 0
