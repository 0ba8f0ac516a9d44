"""The reduced map's page beside the references and the core."""

import json
from pathlib import Path

import numpy as np
import pytest
from conftest import some_of
from old_core import ffi, write
from page_runs import COMPILER, CompiledPage
from tdmf_slip.library.binding import c

from c_core.pages.reduced import ReducedRunner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
GAITS = json.loads((Path(__file__).parent / "reduced_gaits.json").read_text(encoding="utf-8"))["gaits"]
NAMES = {
    "retraction_rate": "retraction_rate",
    "static_friction_ratio": "static_ratio",
    "friction": "friction",
}
OUTCOMES = {"no_start": "NO_START", "no_stance": "NO_STANCE", "no_apex": "NO_APEX", "fallen": "FELL"}
"""Outcomes of the core, by the mode in which a run of the page ends."""


@pytest.fixture(scope="module")
def reduced():
    return CompiledPage(ReducedRunner)


@pytest.mark.parametrize("gait", GAITS, ids=lambda gait: str(gait["given"]))
def test_gaits_are_those_of_the_references(reduced, gait):
    given = reduced.names(gait["given"])
    at_apex = reduced.section("at_apex", tolerance=1e-13, **given)
    assert at_apex.fixed_point(np.array(gait["apex"]) * [1.001, 0.999]) == pytest.approx(
        gait["apex"], abs=1e-11
    )
    found = np.sort(np.linalg.eigvals(at_apex.jacobian))
    assert found == pytest.approx(np.sort(gait["eigenvalues"]), abs=1e-9)
    at_apex.after(gait["apex"])
    values = [at_apex.state(n) for n in ("period", "distance", "speed", "work_of_stride")]
    assert values == pytest.approx([gait[n] for n in ("period", "length", "speed", "stance_work")], abs=1e-10)
    assert (
        np.base_repr(int(at_apex.state("word_code")), 4).translate(str.maketrans("0123", "|-0+"))
        == gait["word"]
    )


@pytest.mark.parametrize(
    "seed", ["friction", "retraction_rate", "touchdown_angle", "ground_slope", "foot_mass", "thrust"]
)
def test_derivatives_are_those_of_differences(reduced, seed):
    given = {"friction": 0.6, "retraction_rate": 0.004, "thrust": 0.01, "ground_slope": 0.01}
    given |= {"foot_mass": 0.1, "touchdown_angle": 0.7}
    point, step = np.array(GAITS[2]["apex"]), 1e-6
    exact = reduced.section("at_apex", seeds=[seed], tolerance=1e-14, **given).after(point, varies=True)

    def ends(change, size):
        given_now = given | ({seed: given[seed] + size} if change is None else {})
        at = point + (0 if change is None else size * np.eye(2)[change])
        return reduced.section("at_apex", tolerance=1e-14, **given_now).after(at).next

    for change, column in [
        (0, exact.jacobian[:, 0]),
        (1, exact.jacobian[:, 1]),
        (None, exact.by_seeds[:, 0]),
    ]:
        assert column == pytest.approx(
            (ends(change, step) - ends(change, -step)) / (2 * step), abs=2e-7 * (1 + abs(column).max())
        )


def drawn(number):
    """A random runner and its apex; some have no stride."""
    random = np.random.default_rng([47, number])
    u = random.uniform
    parameters = {
        "foot.mass": 0.1 * 3 ** u(-1, 1), "leg.damping": 0.2 * 2 ** u(-1, 1), "gravity": 0.01 * 3 ** u(-1, 1),
        "hip.stance_torque": 0.2 * 2 ** u(-1, 1), "hip.touchdown_angle": u(-0.2, 1.2),
        "hip.retraction_rate": u(-0.01, 0.02), "leg.thrust": max(0, u(-0.05, 0.05)),
        "ground.static_friction_ratio": max(1, u(0.5, 1.6)), "ground.stribeck_velocity": max(0, u(-0.2, 0.3)),
    }  # fmt: skip
    inputs = {
        "ground.friction": 10 ** u(-1.5, 1), "ground.height": u(-1, 1), "ground.slope": u(-0.1, 0.1),
        "leg.extension": u(-0.02, 0.02), "hip.external_torque": max(0, u(-0.01, 0.005)),
        "body.external_fx": u(-1e-3, 1e-3), "body.external_fy": u(-2e-3, 2e-3),
    }  # fmt: skip
    return parameters, inputs, [u(0.6, 2.0), u(-0.1, 1.4)]


def core(parameters, inputs, apex):
    """The stride of the core's reduced map, with derivatives by the apex."""
    all_parameters, all_inputs = (
        ffi.new("tdmf_parameters *", c.tdmf_default_parameters()),
        ffi.new("tdmf_inputs *", c.tdmf_default_inputs()),
    )
    write(all_parameters, parameters)
    write(all_inputs, inputs)
    model, solver = ffi.new("tdmf_model *"), ffi.new("tdmf_solver *", c.tdmf_solver_default())
    assert not c.tdmf_model_create(model, all_parameters).variable
    solver.relative_tolerance = 1e-13
    system = ffi.new("tdmf_system *", {"model": model, "inputs": all_inputs})
    return c.tdmf_reduced_map(solver, system[0], apex, 1e4, True, ffi.NULL, 0), (model, all_inputs)


def test_random_strides_are_those_of_the_core(reduced):
    closed, ends = 0, set()
    for number in some_of(range(20000), 400):
        parameters, inputs, apex = drawn(number)
        theirs, _alive = core(parameters, inputs, apex)
        outcome = ffi.string(ffi.cast("tdmf_return_outcome", theirs.outcome)).removeprefix("TDMF_RETURN_")
        mine = reduced.section("at_apex", tolerance=1e-13, **reduced.names(parameters | inputs)).after(
            apex, varies=True
        )
        if mine.outcome != "stopped":
            assert (mine.outcome, OUTCOMES[mine.mode]) == ("ended", outcome), number
            ends.add(outcome)
            continue
        assert outcome == "CLOSED", (number, outcome)
        closed += 1
        assert mine.next == pytest.approx([theirs.apex[0], theirs.apex[1]], abs=1e-9), number
        jacobian = [[theirs.variations[k].apex[i] for k in range(2)] for i in range(2)]
        assert mine.jacobian == pytest.approx(np.array(jacobian), rel=1e-7, abs=1e-7), number
    assert closed > 200 or some_of(range(10), 1) == []
    assert ends >= {"NO_START", "FELL"}
