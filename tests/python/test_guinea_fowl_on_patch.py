"""Guinea fowl on a patch with borders: a change of friction by stride, where it holds all of the slip."""

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip.fmu.simulation import run_unit
from tdmf_slip.paper import guinea_fowl_on_patch
from tdmf_slip.paper.guinea_fowl import published
from tdmf_slip.paper.guinea_fowl_on_patch import BEFORE, PHASES, cross


@pytest.fixture(scope="module")
def gait():
    return guinea_fowl_on_patch.gaits([2.8])[0]


def test_its_gaits_are_stable_over_the_speeds_that_are_named():
    its, said = published()["full_runner"], published()["published"]
    found = guinea_fowl_on_patch.gaits([its["slowest"], its["fastest"], its["fastest"] + 0.1])
    assert [each.stable for each in found] == [True, True, False]
    assert said["slowest"] < its["slowest"] and its["fastest"] < said["fastest"]
    birds = found[0].runner
    assert birds["body.mass"] + birds["foot.mass"] == pytest.approx(published()["runner"]["mass"])


def test_a_patch_as_slippery_as_the_ground_changes_nothing(gait):
    crossed = cross(gait, gait.friction, 1.0)
    assert crossed.falls == 0
    assert crossed.slips == pytest.approx(gait.stride["slip_distance"], abs=1e-9)


@pytest.mark.parametrize("friction", [0.05, 0.2])
def test_a_patch_that_holds_all_of_a_slip_is_a_change_by_stride(gait, friction):
    """A patch as long as a stride has one landing on it, and most slips end before its border."""
    by_stride = tdmf_slip.stride_map(
        gait.runner, gait.apex, strides=2, inputs={"ground.friction": np.array([friction, 2.0])}
    )
    slip = float(by_stride["slip_distance"][0, 0])
    on_patch = cross(gait, friction, float(gait.stride["length"])).slips
    assert slip > 0.05
    assert np.sum(np.abs(on_patch - slip) < 1e-6) > 0.6 * PHASES


def test_a_slip_ends_where_grip_returns(gait):
    """A foot that would slip past the end of the patch stops behind it: of some the slip is cut short."""
    slips = cross(gait, 0.05, 0.25 * float(gait.stride["length"])).slips
    whole = float(np.max(cross(gait, 0.05, float(gait.stride["length"])).slips))
    touched = slips[slips > 1e-3]
    assert 5 < len(touched) < PHASES and np.max(touched) < whole
    assert np.ptp(touched) > 0.1 * whole


def test_co_simulation_sees_the_same_slip(gait):
    stride = float(gait.stride["length"])
    begin, number = BEFORE * stride, 20
    patch = {"ground.patch_begin": begin, "ground.patch_end": begin + stride, "ground.patch_friction": 0.1}
    start = {**gait.runner, **gait.start_values, **patch, "foot.x": number * stride / PHASES}
    end = (BEFORE + 3.5) * gait.stride["period"]
    run = run_unit(start, stop_time=end, interface="cs")
    slipped = float(np.max(run["stride.slip_distance"]))
    assert slipped > 0.05
    assert slipped == pytest.approx(cross(gait, 0.1, stride).slips[number], abs=1e-7)
