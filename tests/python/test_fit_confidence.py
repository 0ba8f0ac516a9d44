"""Confidence of a fit: coverage of its intervals, priors, outliers, data left out, and other starts."""

import math

import numpy as np
import pytest
from conftest import RELEASE, release
from tdmf_slip import InputError, find_gait, fit
from tdmf_slip.fitting.measurements import Measured, Measurements
from tdmf_slip.fitting.problem import Problem
from tdmf_slip.fitting.result import QUANTILE
from tdmf_slip.fitting.search import HUBER, across_folds, loss_of, weights_of
from test_fit import MEASURED, measured

SEEDS, MINIMUM, MAXIMUM = (400, 0.92, 0.98) if RELEASE else (20, 0.80, 1.0)
"""Limits of coverage: by chance, the share of 400 is outside once in 200 times, that of 20 once in 390."""
WEAK = ("speed", "frequency", "stance_time", "peak_force")
WEAK_RUNNER = {"ground.friction": 0.6, "leg.damping": 0.234}
TORQUES = (0.14, 0.17, 0.2, 0.24, 0.28)
SCENARIOS = {
    "slips all the stance": (
        *("full", ({"ground.friction": 0.2},), MEASURED, 0.005),
        *(("ground.friction", "leg.stiffness"), ()),
    ),
    "sticks": (
        *("full", ({"ground.friction": 10.0},), MEASURED, 0.005),
        *(("hip.stance_torque", "leg.stiffness", "leg.damping"), ()),
    ),
    "weak": (
        *("reduced", tuple({**WEAK_RUNNER, "hip.stance_torque": torque} for torque in TORQUES), WEAK, 0.08),
        *(("leg.damping", "ground.friction"), ("hip.stance_torque",)),
    ),
}
"""Map, runners, measured quantities, relative error, shared parameters, and parameters of single rows.

The weak scenario has five speeds and errors of 8 %."""
FIRST = {"ground.friction": 0.6}


def disturbed(row, random):
    return {
        name: Measured(max(of.value + of.error * random.normal(), 0.0), of.error) for name, of in row.items()
    }


def one_row(row, where="a gait"):
    return Measurements((row,), where)


@pytest.mark.parametrize("name", SCENARIOS if RELEASE else list(SCENARIOS)[:1])
def test_intervals_hold_the_truth_as_often_as_they_say(name):
    """Errors are normal, with seeds from 0 on; intervals have 95 % confidence, also those of failed fits.

    In the weak scenario, 386 of 400 fits converged; the others report that they have not. Its intervals
    follow the likelihood: in all but one of the seeds whose interval contains the true friction, chi square
    has risen there by less than 3.84. The likelihood ratio is no chi square in this scenario: its mean is
    1.27.
    """
    model, runners, names, error, free, each = SCENARIOS[name]
    gaits = [find_gait(runner, model=model) for runner in runners]
    rows = [measured(gait, names, error) for gait in gaits]
    begin = gaits[0] if len(gaits) == 1 else find_gait(FIRST, model=model)
    true, held = {of: gaits[0].runner[of] for of in free}, dict.fromkeys(free, 0)
    fitted = 0
    for seed in range(SEEDS):
        random = np.random.default_rng(seed)
        data = Measurements(tuple(disturbed(row, random) for row in rows), "disturbed gaits")
        found = fit(begin.runner, data, free, vary_each=each, guess=begin.apex, profile=free)
        fitted += found.converged
        for of, value in true.items():
            held[of] += found.parameters[of].low <= value <= found.parameters[of].high
    shares = {of: count / SEEDS for of, count in held.items()}
    assert all(MINIMUM <= share <= MAXIMUM for share in shares.values()), (shares, fitted)
    assert fitted >= 0.95 * SEEDS, fitted


def test_an_interval_ends_where_the_profile_has_risen_by_its_quantile():
    """Fits with the parameter held at either end have a chi square 3.84 above the least."""
    model, runners, names, error, free, each = SCENARIOS["weak"]
    random = np.random.default_rng(3)
    rows = tuple(disturbed(measured(find_gait(r, model=model), names, error), random) for r in runners)
    data = Measurements(rows, "weak")
    found = fit(FIRST, data, free, vary_each=each, model=model, profile=["ground.friction"])
    friction = found.parameters["ground.friction"]
    assert friction.is_profiled and not found.parameters["leg.damping"].is_profiled
    for end in (friction.low, friction.high):
        held = fit(
            {"ground.friction": end}, data, ["leg.damping"], vary_each=each, model=model, profile=False
        )
        assert held.chi_square - found.chi_square == pytest.approx(QUANTILE**2, rel=0.05)
    assert friction.high - friction.value > 1.1 * (friction.value - friction.low)


def test_an_interval_that_the_data_do_not_close_ends_at_the_range():
    """A thrust that may be zero: its interval ends there, and reports so."""
    gait = find_gait({"leg.thrust": 0.02})
    row = measured(gait, ("peak_force",), 0.1)
    estimate = fit({"leg.thrust": 0.02}, one_row(row), ["leg.thrust"]).parameters["leg.thrust"]
    assert estimate.low == 0.0 and "range" in estimate.ends_at
    assert estimate.high > 0.03


def test_a_search_across_folds_that_begins_with_a_fall_finds_nothing():
    gait = find_gait()
    names = ("speed", "peak_force")
    data = one_row(measured(gait, names, 0.01))
    request = fit(None, data, ["hip.touchdown_angle"], profile=False).request
    problem = Problem(request, gait)
    assert across_folds(problem, np.array([12.0]), 0) is None
    assert across_folds(problem, np.array([0.1]), 0) is not None


def test_the_command_takes_what_is_known_and_leaves_data_out(tmp_path, command):
    table = tmp_path / "data.csv"
    header = "speed [m/s],speed_error [m/s],frequency [Hz],frequency_error [Hz]"
    table.write_text(f"{header}\n1.05,0.01,0.0405,0.0004\n", encoding="utf-8")
    arguments = ["fit", str(table), "--vary", "hip.stance_torque", "--prior", "leg.stiffness=1.0,0.05"]
    printed = command.json(*arguments, "--robust", "--without-each")
    assert set(printed["parameters"]) == {"hip.stance_torque", "leg.stiffness"}
    assert printed["priors"][0]["error"] == 0.05 and printed["degrees_of_freedom"] == 1
    assert [(one["row"], one["quantity"]) for one in printed["without"]] == [(1, "speed"), (1, "frequency")]
    assert printed["parameters"]["leg.stiffness"]["profiled"]
    status, out, _ = command(*arguments, "--linear", "--scale-errors", "--without-each")
    assert status == 0 and "the errors are taken" in out
    status, out, _ = command(*arguments, "--linear", "--without-each")
    assert status == 0 and "hip.stance_torque moves by errors" in out


def test_a_prior_and_a_datum_weigh_by_their_errors():
    """Two sources for one parameter give a mean weighted by inverse squared errors, with a smaller error."""
    gait = find_gait({"ground.friction": 0.6})
    row = measured(gait, MEASURED, 1e-3)
    free = ["leg.stiffness"]
    alone = fit(None, one_row(row), free, profile=False).parameters["leg.stiffness"]
    known = (1.002, 0.5 * alone.standard_error)
    both = fit(None, one_row(row), free, priors={"leg.stiffness": known}, profile=False)
    weights = np.array([1.0 / alone.standard_error**2, 1.0 / known[1] ** 2])
    estimate = both.parameters["leg.stiffness"]
    assert estimate.value == pytest.approx(weights @ [alone.value, known[0]] / weights.sum(), rel=1e-5)
    assert estimate.standard_error == pytest.approx(weights.sum() ** -0.5, rel=1e-2)
    assert both.degrees_of_freedom == len(MEASURED) + 1 - 1
    (prior,) = both.priors
    assert prior.residual == pytest.approx((estimate.value - known[0]) / known[1])
    assert both.as_json()["priors"][0]["value"] == 1.002


def far_off(count=6):
    """Speeds under one torque; one of them is an outlier of twenty errors."""
    gait = find_gait({"ground.friction": 0.6})
    speed = gait.stride["speed"]
    values = [speed * (1.0 + 0.01 * off) for off in (0.5, -1.0, 0.8, -0.3, 0.2)[: count - 1]]
    return gait, Measurements(
        tuple({"speed": Measured(v, 0.01 * speed)} for v in (*values, 1.2 * speed)), "speeds"
    )


def test_a_datum_that_is_far_off_changes_a_robust_fit_little():
    gait, data = far_off()
    true = gait.runner["hip.stance_torque"]
    plain, robust = (fit(None, data, ["hip.stance_torque"], robust=robust) for robust in (False, True))
    off = [abs(found.parameters["hip.stance_torque"].value / true - 1.0) for found in (plain, robust)]
    assert off[1] < 0.3 * off[0]
    assert robust.converged and plain.converged
    estimate = robust.parameters["hip.stance_torque"]
    assert estimate.low < true < estimate.high
    assert not plain.parameters["hip.stance_torque"].low < true


def test_hubers_loss_has_the_slope_that_the_weights_say():
    residuals = np.array([-3.0, -HUBER, -0.2, 0.0, 1.0, 5.0])
    step = 1e-6
    for k in range(len(residuals)):
        aside = step * np.eye(len(residuals))[k]
        slope = (loss_of(residuals + aside, True) - loss_of(residuals - aside, True)) / (2.0 * step)
        weighted = 2.0 * weights_of(residuals, True)[k] ** 2 * residuals[k]
        assert slope == pytest.approx(weighted, abs=1e-5)
    assert loss_of(residuals, False) == pytest.approx(residuals @ residuals)


def test_a_fit_without_a_datum_is_that_of_the_others():
    _, data = far_off()
    found = fit(None, data, ["hip.stance_torque"])
    fewer = found.without(6, "speed")
    again = fit(None, Measurements(data.rows[:5], "others"), ["hip.stance_torque"])
    name = "hip.stance_torque"
    for of in ("value", "low", "high"):
        assert getattr(fewer.parameters[name], of) == pytest.approx(
            getattr(again.parameters[name], of), rel=1e-3
        )
    assert fewer.degrees_of_freedom == found.degrees_of_freedom - 1
    shifts = [abs(found.shifts(left)[name]) for left in found.without_each().values()]
    assert len(shifts) == 6 and int(np.argmax(shifts)) == 5
    assert shifts[5] > 3.0 > max(shifts[:5])
    with pytest.raises(InputError, match="not among the data"):
        found.without(7, "speed")
    row = {"speed": Measured(1.05, 0.01), "frequency": Measured(0.04, 0.0004)}
    found = fit(None, one_row(row), ["hip.stance_torque", "leg.stiffness"], profile=False)
    assert found.without_each() == {}
    with pytest.raises(InputError, match="less is left than is fitted"):
        found.without(1, "speed")


def test_errors_are_scaled_by_the_residuals_on_request():
    """Intervals do not depend on the scale of the errors; Student's quantile is for 5 degrees of freedom."""
    _, data = far_off()
    smaller = Measurements(
        tuple({"speed": Measured(of.value, 0.1 * of.error)} for of in (row["speed"] for row in data.rows)),
        "small",
    )
    intervals = []
    for measurements in (data, smaller):
        found = fit(None, measurements, ["hip.stance_torque"], scale_errors=True, profile=False)
        estimate = found.parameters["hip.stance_torque"]
        assert estimate.high - estimate.value == pytest.approx(2.5706 * estimate.standard_error, rel=1e-4)
        intervals.append((estimate.low, estimate.high))
    assert intervals[0] == pytest.approx(intervals[1], rel=1e-4)
    plain = fit(None, data, ["hip.stance_torque"], profile=False)
    known, factor = plain.parameters["hip.stance_torque"], math.sqrt(plain.chi_square / 5)
    scaled = fit(None, data, ["hip.stance_torque"], scale_errors=True).parameters["hip.stance_torque"]
    assert scaled.low < known.low < known.high < scaled.high and scaled.is_profiled
    assert scaled.standard_error == pytest.approx(factor * known.standard_error, rel=1e-6)
    with pytest.raises(InputError, match="scale_errors"):
        fit(None, one_row({"speed": Measured(1.0, 0.1)}), ["hip.stance_torque"], scale_errors=True)


def test_a_search_that_ends_for_want_of_gaits_has_not_converged(monkeypatch):
    """The search ends at a fold, an error off: chi square is small enough, but not least."""
    row = {"speed": Measured(0.6, 0.1)}
    monkeypatch.setattr("tdmf_slip.fitting.search.across_folds", lambda *arguments: None)
    found = fit(None, one_row(row), ["hip.touchdown_angle"])
    assert found.chi_square > 1.0 and not found.converged
    assert not any(estimate.is_profiled for estimate in found.estimates)


def test_other_starts_find_what_the_first_does_not():
    """The runner's own gait leads to another minimum than the true parameters."""
    true = find_gait(
        {"ground.friction": 2.5479, "hip.stance_torque": 0.11006, "hip.touchdown_angle": 0.71879}
    )
    row = measured(true, ("speed", "peak_force"), 0.01)
    free = ["hip.stance_torque", "hip.touchdown_angle"]
    one, more = (fit({"ground.friction": 2.5479}, one_row(row), free, starts=n) for n in (1, 5))
    assert more.chi_square < 1e-6 and more.converged
    assert more.starts > 1 and one.starts == 1 and more.chi_square <= one.chi_square


@release
def test_a_profile_that_finds_a_better_fit_restarts():
    """The first search ends at chi square 11.05; with the friction held at 0.33 it is 8.35."""
    model, runners, names, error, free, each = SCENARIOS["weak"]
    random = np.random.default_rng(0)
    gaits = [find_gait({**runner, "leg.damping": 0.2}, model=model) for runner in runners]
    data = Measurements(tuple(disturbed(measured(gait, names, error), random) for gait in gaits), "weak")
    linear = fit(FIRST, data, free, vary_each=each, model=model, profile=False)
    found = fit(FIRST, data, free, vary_each=each, model=model, profile=["leg.damping", "ground.friction"])
    assert found.chi_square < linear.chi_square - 1.0
