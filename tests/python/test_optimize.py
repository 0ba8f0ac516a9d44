"""Optimal runners: gradients against differences, optima against fine grids, and refusals."""

import json

import numpy as np
import pytest
from conftest import CLAMPED, release, some_of
from tdmf_slip import InputError, TargetNotMetError, find_gait, optimize, sweep
from tdmf_slip.library.fixed_point import gait_near
from tdmf_slip.library.quantities import known_quantities
from tdmf_slip.library.strides import strides_from
from tdmf_slip.optimization.gaits import MINIMUM, Gaits, Space, spectrum_of
from tdmf_slip.optimization.problem import Goal, Problem
from tdmf_slip.variables.parameters import read_parameters

STIFF = {"leg.stiffness": 2.0, "ground.friction": 0.6}
LIGHT = {"foot.mass": 0.03, "ground.friction": 0.6}
SLIPPING = {"ground.friction": 0.2}
STICKING = {"ground.friction": 10.0}
VARIED = ("hip.touchdown_angle", "hip.stance_torque", "leg.damping", "ground.friction")
ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"


def space_around(gait, names=VARIED):
    """Bounds a half below and above a runner's values."""
    return Space({name: (0.5 * gait.runner[name], 1.5 * gait.runner[name]) for name in names})


@pytest.mark.parametrize("model", ["full", "reduced"])
@pytest.mark.parametrize("runner", some_of([SLIPPING, STIFF, read_parameters("human"), LIGHT, STICKING], 3))
def test_gradients_are_those_of_differences_of_solved_gaits(runner, model):
    first = find_gait(runner, model=model)
    space, step = space_around(first), 3e-6  # the error of differences falls with its square
    gaits = Gaits(first.runner, space, known_quantities(first.runner), spectrum=True)
    gait = gaits.candidate(first, space.coordinates_of(first.runner))
    below_a_radius = Problem(Goal("speed", radius=0.9), {}).margins
    for k, aside in enumerate(step * np.eye(4)):
        low, high = (
            gaits.candidate(gait_near(space.runner_at(first.runner, at), first.apex), at)
            for at in (gait.at - aside, gait.at + aside)
        )
        assert low.region == gait.region == high.region
        of_quantities = (high.values - low.values) / (2.0 * step)
        assert gait.slopes[:, k] == pytest.approx(of_quantities, abs=1e-5 * np.max(np.abs(gait.values)))
        of_eigenvalues = (high.spectrum.sizes - low.spectrum.sizes) / (2.0 * step)
        counted = gait.spectrum.sizes > MINIMUM
        assert gait.spectrum.slopes[counted, k] == pytest.approx(of_eigenvalues[counted], abs=1e-4)
        (below, _), (_, by), (above, _) = (below_a_radius(of) for of in (low, gait, high))
        assert by[counted, k] == pytest.approx((above - below)[counted] / (2.0 * step), abs=3e-3)
        of_fold = (high.spectrum.fold - low.spectrum.fold) / (2.0 * step)
        assert gait.spectrum.fold_slopes[k] == pytest.approx(of_fold, abs=1e-4)
    assert gait.spectrum.sizes[0] == pytest.approx(first.lambda_max, rel=1e-12)


def test_sizes_of_complex_pairs_have_derivatives():
    generator = np.random.default_rng(5)
    pairs = 0
    for _ in range(40):
        matrix, change = generator.normal(size=(2, 4, 4))
        spectrum = spectrum_of(matrix, [change])
        low, high = (spectrum_of(matrix + h * change, [change]).sizes for h in (-1e-6, 1e-6))
        assert spectrum.slopes[:, 0] == pytest.approx((high - low) / 2e-6, abs=1e-6)
        values = np.linalg.eigvals(matrix)
        assert spectrum.sizes[0] == pytest.approx(np.max(np.abs(values)), rel=1e-12)
        pairs += bool(np.iscomplex(values[np.argmax(np.abs(values))]))
    assert 5 < pairs < 35


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_optimum_over_one_parameter_is_that_of_a_fine_grid(sign):
    """The cost of transport over the angle has its minimum inside; the speed has its maximum on a kink."""
    quantity, asked = ("cost_of_transport", "minimize") if sign > 0 else ("speed", "maximize")
    over, setting = ("ground.friction", {}) if sign < 0 else (ANGLE, SLIPPING)
    low, high = (0.45, 0.55) if sign < 0 else (0.7, 0.82)
    best = optimize(setting, {over: (low, high)}, starts=1, **{asked: quantity})
    grid = sweep(setting, {over: np.linspace(low, high, 41)}).gaits
    values = grid[quantity].values
    index = np.argmin(sign * values)
    assert len(values) == 41 and 0 < index < 40
    assert best.parameters[over] == pytest.approx(grid[over].values[index], abs=(high - low) / 40)
    assert 0.0 <= sign * (values[index] - best.value) < 1e-3 * best.value
    assert best.why == "" and max(best.remaining_improvement.values()) <= 1e-4


def test_an_optimum_over_two_parameters_is_that_of_a_fine_grid():
    """Cheapest gait at a speed: the speed determines the angle from the torque, so one parameter is free."""
    over = {ANGLE: (0.6, 0.95), TORQUE: (0.1, 0.5)}
    best = optimize(SLIPPING, over, minimize="cost_of_transport", target={"speed": 0.9}, starts=1)
    assert best.gait.stride["speed"] == pytest.approx(0.9, rel=1e-8)
    assert best.active_bounds == {} and best.why == ""
    smallest = []
    for angle in best.parameters[ANGLE] + np.linspace(-0.05, 0.05, 11):
        row = sweep({**SLIPPING, ANGLE: angle}, {TORQUE: best.parameters[TORQUE] * np.linspace(0.9, 1.1, 9)})
        speeds, costs = (row.gaits[name].values for name in ("speed", "cost_of_transport"))
        assert speeds[0] < 0.9 < speeds[-1]
        smallest.append(np.interp(0.9, speeds, costs))
    assert np.argmin(smallest) == 5
    assert min(smallest) == pytest.approx(best.value, abs=1e-5)


def test_stability_is_kept_where_it_is_asked_for():
    over = {ANGLE: (0.5, 0.9), TORQUE: (0.1, 0.4)}
    free = optimize({}, over, maximize="speed", starts=1)
    assert free.limits == ()
    kept = optimize({}, over, maximize="speed", stable=0.85, starts=1)
    assert free.gait.lambda_max > 0.857
    assert kept.gait.lambda_max == pytest.approx(0.85, abs=1e-8)
    assert kept.limits == ("stability",) and kept.why == "" and kept.value < free.value


def test_a_speed_that_no_gait_has_is_reported_with_the_nearest(command):
    arguments = ["--minimize", "cost_of_transport", "--vary", f"{TORQUE}=0.1:0.3", "--target", "speed=9"]
    status, out, said = command("optimize", *arguments, "--starts", "1", "--json")
    assert status == 1 and "no gait with speed 9" in said and json.loads(out)["nearest"]["speed"] < 9.0
    with pytest.raises(TargetNotMetError, match="no gait with speed 9 was found") as refused:
        optimize({}, {TORQUE: (0.1, 0.3)}, minimize="cost_of_transport", target={"speed": 9}, starts=1)
    nearest = refused.value.nearest
    fastest = optimize({}, {TORQUE: (0.1, 0.3)}, maximize="speed", starts=1)
    assert nearest.stride["speed"] == pytest.approx(fastest.value, rel=1e-6)


def test_the_command_prints_a_table_before_and_after(command):
    arguments = ["--maximize", "speed", "--vary", f"{TORQUE}=0.1:0.25", "--starts", "1"]
    status, out, _ = command("optimize", *arguments)
    assert status == 0
    rows = {line.split()[0]: line.split() for line in out.splitlines() if line}
    assert rows[TORQUE] == [TORQUE, "k", "l0^2", "0.2", "0.25", "upper"]
    assert rows["word"][1:] == ["+0-0+", "+0-"]
    assert "a local optimum to first order" in out and "one search" in out
    printed = command.json("optimize", *arguments)
    assert {"parameters", "before", "after", "word", "stable", "active_bounds"} <= set(printed)
    assert printed["parameters"] == {TORQUE: 0.25} and printed["active_bounds"] == {TORQUE: "upper"}
    assert printed["after"]["speed"] == pytest.approx(float(rows["speed"][-1]), rel=1e-8)
    assert printed["after"]["speed"] > printed["before"]["speed"]
    again = gait_near(find_gait({TORQUE: 0.25}).runner, printed["apex"])
    assert again.stride["speed"] == pytest.approx(printed["after"]["speed"], rel=1e-9)


def test_a_pareto_front_leads_from_one_best_to_the_other(command):
    arguments = ["--minimize", "cost_of_transport", "--maximize", "speed", "--vary", f"{TORQUE}=0.15:0.3"]
    arguments += ["--vary", f"{ANGLE}=0.65:0.75", "--starts", "1", "--points", "3"]
    printed = command.json("optimize", *arguments)
    assert printed["objectives"] == ["cost_of_transport", "speed"]
    costs, speeds = (
        np.array([best["after"][name] for best in printed["front"]]) for name in printed["objectives"]
    )
    assert len(costs) == 3 and np.all(np.diff(costs) > 0.0) and np.all(np.diff(speeds) > 0.0)
    assert np.diff(speeds) == pytest.approx(np.diff(speeds)[0], rel=1e-6)
    assert [best["problem"] for best in printed["front"]] == [None] * 3
    over = {TORQUE: (0.15, 0.3), ANGLE: (0.65, 0.75)}
    cheaper = optimize({}, over, minimize="cost_of_transport", target={"speed": speeds[1]}, starts=1)
    assert cheaper.value == pytest.approx(costs[1], rel=1e-8)


@pytest.mark.parametrize("bounds", [((1.0, 2.0), 3.0), (0.1,), "12", None, (0.1, float("nan"))])
def test_bounds_that_are_none_are_refused(bounds):
    with pytest.raises(InputError, match=r"hip\.kp.*allowed"):
        optimize({}, {"hip.kp": bounds}, maximize="speed")
    with pytest.raises(InputError, match="allowed: 1 to 12"):
        optimize({}, {}, maximize="speed")


def test_other_starts_find_what_lies_beyond_the_runners_own_basin():
    """Searches end at a slip of 0.2363 from the runner's own gait, at 0.2108 from (.434, .4967, .2408)."""
    over = {ANGLE: (0.4, 0.9), TORQUE: (0.05, 0.5), "leg.damping": (0.1, 0.3)}
    asked = {"minimize": "slip_distance", "target": {"speed": 0.9}, "stable": True}
    own = {**CLAMPED, "ground.friction": 0.3}
    near = {**own, ANGLE: 0.434, TORQUE: 0.4967, "leg.damping": 0.2408}
    known = optimize(near, over, **asked, starts=1)
    best = optimize(own, over, **asked, starts=4)
    assert best.value == pytest.approx(0.210811, abs=1e-6) and best.value <= known.value + 1e-9
    assert best.why == "" and best.is_local
    assert best.basins >= 2 and 2 <= best.starts <= 4
    alone = optimize(own, over, **asked, starts=1)
    assert alone.value > 0.23 and alone.starts == 1 == alone.basins
    again = strides_from(best.gait.runner, best.gait.apex)
    assert np.max(np.abs(again.residual / best.gait.runner.scales)) < 1e-11
    printed = best.as_json()
    assert printed["local"] and printed["basins"] == best.basins and printed["starts"] == best.starts


def test_a_slip_of_none_is_the_least_of_all():
    best = optimize(STICKING, {ANGLE: (0.6, 0.8)}, minimize="slip_distance", starts=1)
    assert best.value < 1e-10 and not best.is_local and "global" in repr(best)


@release
def test_a_search_goes_through_pieces_too_narrow_for_differences():
    """Eigenvalues have no derivatives on the edge of an event; far from their limit none are needed."""
    over = {ANGLE: (0.4, 0.95), "leg.thrust": (0.0, 0.2), "hip.kp": (0.06, 0.2)}
    runner = {"ground.friction": 0.5049635075061091}
    asked = {"minimize": "frequency", "target": {"speed": 0.9559354532704964}, "stable": True}
    best = optimize(runner, over, **asked, starts=1)
    assert best.why == "" and best.value < 0.0138 and best.gait.lambda_max < 0.99


def test_the_best_point_along_the_edge_of_a_fold_is_found():
    """One of two parameters is free along the edge; a grid over it has no better point."""
    slow, over = {**STICKING, TORQUE: 0.11}, {TORQUE: (0.1, 0.12), "leg.damping": (0.19, 0.21)}
    best = optimize(slow, over, minimize="cost_of_transport", starts=1)
    assert best.limits == ("fold",) and best.why == "" and max(best.remaining_improvement.values()) <= 1e-4
    for damping in (0.19, 0.2, 0.21):
        one = {**slow, "leg.damping": damping}
        at = optimize(one, {TORQUE: (0.1, 0.12)}, minimize="cost_of_transport", starts=1)
        assert best.value <= at.value + 1e-7


@release
def test_eigenvalues_change_on_the_edge_of_a_word_and_of_the_bounds():
    """Both ways along the thrust leave the region, to another word and below zero; a slanted one does not."""
    asked = {"maximize": "frequency", "stable": True, "starts": 1}
    over = {TORQUE: (0.08, 0.45), "leg.thrust": (0.0, 0.2)}
    best = optimize({"ground.friction": 2.463, **CLAMPED}, over, **asked)
    assert best.why == "" and best.limits == ("stability",)
    assert best.gait.lambda_max == pytest.approx(0.99, abs=1e-7)
    assert best.active_bounds == {"leg.thrust": "lower"}


@release
def test_constraints_that_are_nearly_met_are_met():
    """The search for a feasible gait ends early, at a speed off by 7e-4, because its objective is flat."""
    over = {ANGLE: (0.4, 0.95), "leg.stiffness": (0.7, 1.5), "hip.liftoff_angle_factor": (0.8, 1.6)}
    asked = {"minimize": "duty_factor", "target": {"speed": 1.0325132490240172}, "stable": True, "starts": 1}
    best = optimize({"ground.friction": 0.38539484074315605}, over, **asked)
    assert best.gait.stride["speed"] == pytest.approx(1.0325132490240172, rel=1e-7)
    assert best.gait.lambda_max < 0.99
