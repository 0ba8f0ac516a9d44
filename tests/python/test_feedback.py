"""Feedback from stride to stride: gains against differences of the return map, brute force and simulation."""

import dataclasses
import pathlib

import numpy as np
import pytest
import tdmf_slip
from conftest import RELEASE, in_units
from tdmf_slip import (
    InputError,
    RunError,
    Runner,
    apex_covariance,
    controllability,
    dead_beat,
    find_gait,
    lqr,
    place_poles,
)
from tdmf_slip.feedback.controllability import Modes, controllability_of, lasting_modes, linearize
from tdmf_slip.feedback.gains import dead_beat_gain, riccati_gain
from tdmf_slip.library.engine import instruction_sets
from tdmf_slip.library.return_map import stride_from
from tdmf_slip.variables.parameters import read_parameters

ANGLE, TORQUE, THRUST = "hip.touchdown_angle", "hip.stance_torque", "leg.thrust"
ALL = (ANGLE, TORQUE, "hip.retraction_rate", "hip.kp", "hip.kd", "hip.liftoff_angle_factor", THRUST)
HUMAN = pathlib.Path(__file__).parent / "fast_human.toml"
DRAWN = 24 if RELEASE else 6
FRICTIONS = (0.1, 0.2, 0.6, 1.0, 10.0)
SIZES = {1: 1e-6, 2: 1e-5, 3: 1e-5}
"""Deviations that dead-beat laws remove, by number of settings: with fewer settings, the way is longer."""
RUNNERS = {
    "default": {THRUST: 0.05},
    "slippery": {"ground.friction": 0.1, THRUST: 0.05},
    "human": {**read_parameters(HUMAN), THRUST: 0.001},
    "stiff": {"leg.stiffness": 4.0, "gravity": 0.04, TORQUE: 0.8, "hip.kp": 0.4, "hip.kd": 0.2, THRUST: 0.05},
}


@pytest.fixture(scope="module")
def gaits():
    return {friction: find_gait({"ground.friction": friction}) for friction in FRICTIONS}


def next_apex(runner, apex, settings):
    """Next apex by the return map alone."""
    for name, value in settings.items():
        runner = runner.replace({name: value})
    return stride_from(runner, apex, ANGLE)[0]


def strides_under(law, apex, count):
    """Apices of strides in a row, with the first one, by a plain loop over the return map."""
    apices = [apex]
    for _ in range(count):
        apices.append(next_apex(law.linearization.gait.runner, apices[-1], law.inputs_at(apices[-1])))
    return np.array(apices)


def deviations(law, apices):
    gait = law.linearization.gait
    return (apices - gait.apex) / gait.runner.scales


def away(gait, size, seed=0):
    """Apex at a distance from that of the gait, over the scales, in a direction of all coordinates."""
    direction = np.random.default_rng(seed).normal(size=len(gait.apex))
    return gait.apex + size * direction / np.linalg.norm(direction) * gait.runner.scales


# ---- to first order ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", RUNNERS)
def test_both_matrices_are_differences_of_the_return_map(name):
    gait = find_gait(RUNNERS[name])
    model = linearize(gait, ALL)
    step = 1e-6
    for i, scale in enumerate(model.scales):
        moved = step * scale * np.eye(len(gait.apex))[i]
        ends = [next_apex(gait.runner, gait.apex + side * moved, {}) for side in (1, -1)]
        column = (ends[0] - ends[1]) / (2 * step) / model.scales
        assert column == pytest.approx(model.state_matrix[:, i], rel=1e-6, abs=1e-7)
    for i, setting in enumerate(ALL):
        value, size = gait.runner[setting], step * model.setting_scales[i]
        ends = [next_apex(gait.runner, gait.apex, {setting: value + side * size}) for side in (1, -1)]
        column = (ends[0] - ends[1]) / (2 * step) / model.scales
        assert column == pytest.approx(model.input_matrix[:, i], rel=1e-6, abs=1e-6), setting


def test_a_foot_that_sticks_makes_the_stride_forget_three_modes_and_one_that_slips_two(gaits):
    forgets = {
        friction: controllability(gaits[friction], [ANGLE], negligible=1e-9).negligible
        for friction in FRICTIONS
    }
    assert forgets == {0.1: 2, 0.2: 2, 0.6: 3, 1.0: 3, 10.0: 3}
    assert controllability(gaits[0.2], [ANGLE]).negligible == 3  # the fourth eigenvalue is 1.2e-8


def test_gains_of_a_scaled_runner_are_scaled():
    """A scaled runner (m = 80, k = 20000, l0 = 0.9) has the same closed loop, and gains in its units."""
    m, k, l0 = 80.0, 20_000.0, 0.9
    energy, time = k * l0**2, (m / k) ** 0.5
    gait, usual, runner = find_gait(), Runner(), in_units(m, k, l0)
    other = find_gait(runner, guess=gait.apex * runner.scales)
    of_settings = {ANGLE: 1.0, TORQUE: energy, "hip.kp": energy, "hip.kd": energy * time}
    of_settings |= {"leg.extension": l0, "body.external_fx": k * l0, "hip.retraction_rate": 1.0 / time}
    for name, scale in of_settings.items():
        assert linearize(other, [name]).setting_scales == pytest.approx([scale], rel=1e-12), name
    for make in (dead_beat, lqr):
        ours, theirs = make(gait, [ANGLE, TORQUE, "hip.kd"]), make(other, [ANGLE, TORQUE, "hip.kd"])
        sizes = np.array([1.0, energy, energy * time])
        expected = np.asarray(ours.gain) * sizes[:, None] / runner.scales
        assert np.asarray(theirs.gain) == pytest.approx(expected, rel=1e-6, abs=1e-9 * np.abs(expected).max())
        ours, theirs = (
            apex_covariance(dataclasses.replace(law, noise=1e-3 * of.scales), 1e-2 * of.scales[0])
            for law, of in ((ours, usual), (theirs, runner))
        )
        sizes = np.outer(runner.scales, runner.scales)
        assert theirs / sizes == pytest.approx(ours, rel=1e-6, abs=1e-9 * ours.max())


# ---- controllability ---------------------------------------------------------------------------------------


def test_a_setting_moves_a_mode_by_the_left_eigenvector_of_the_whole_jacobian():
    gait = find_gait(friction=0.43)
    model, found = (make(gait, [ANGLE, TORQUE]) for make in (linearize, controllability))
    values, left = np.linalg.eig(model.state_matrix.T)
    order = np.argsort(-np.abs(values))[: len(found.eigenvalues)]
    assert found.eigenvalues == pytest.approx(values[order], abs=1e-9)
    expected = np.abs(left[:, order].T @ model.input_matrix)
    assert found.modal_controllability == pytest.approx(expected, rel=1e-6)


def test_controllability_is_reported_in_numbers(gaits):
    alone = controllability(gaits[0.6], [ANGLE])
    both = controllability(gaits[0.6], [ANGLE, TORQUE])
    assert (alone.rank, alone.strides) == (3, 3) and (both.rank, both.strides) == (3, 2)
    assert alone.controllable and alone.stabilizable and not len(alone.uncontrollable)
    # The touchdown angle hardly moves the mode of the speed; the torque does.
    assert (
        both.modal_controllability[0, 0] < 0.2 * both.modal_controllability[0, 1]
        and both.conditioning > 5 * alone.conditioning
    )
    assert {"runner", "inputs", "eigenvalues", "negligible", "rank", "singular_values"} < set(both.as_json())
    assert repr(alone).startswith(
        "<Controllability by hip.touchdown_angle: 3 of 3 modes, smallest over largest"
    )
    law = lqr(gaits[0.6], [ANGLE, TORQUE])
    assert repr(law).startswith("<Feedback by hip.touchdown_angle, hip.stance_torque at the gait +0-0+,")
    assert f"largest eigenvalue {law.lambda_max:.4g}, 0.8556 without feedback>" in repr(law)


def test_modal_controllability_is_by_left_eigenvectors_of_the_whole_jacobian(gaits):
    """The whole Jacobian is an independent check: the library uses only the modes that last."""
    model = linearize(gaits[1.0], [ANGLE, TORQUE])
    values, left = np.linalg.eig(model.state_matrix.T)
    left = left[:, np.argsort(-np.abs(values))[:3]]
    expected = np.abs((left / np.linalg.norm(left, axis=0)).T @ model.input_matrix)
    found = controllability(gaits[1.0], [ANGLE, TORQUE]).modal_controllability
    assert found == pytest.approx(expected, rel=1e-8)


def test_a_mode_that_no_setting_moves_is_named():
    modes = Modes(np.eye(3), np.diag([1.1, 0.5, -0.3]), np.array([[0.0], [1.0], [2.0]]))
    found = controllability_of(Runner(), modes, (ANGLE,))
    assert found.rank == 2 and found.uncontrollable == pytest.approx([1.1]) and found.strides is None
    assert not found.controllable and not found.stabilizable
    with pytest.raises(ArithmeticError, match="not controllable"):
        dead_beat_gain(modes.state_matrix, modes.input_matrix)


def test_the_settings_of_so_few_strides_reach_the_gait_and_those_of_one_less_do_not(gaits):
    """Brute force: least squares over all settings of n strides, from random apices."""
    compared = 0
    power = np.linalg.matrix_power
    for friction, gait in gaits.items():
        for settings in ([ANGLE], [ANGLE, TORQUE], [ANGLE, TORQUE, "hip.kp"]):
            modes = lasting_modes(linearize(gait, settings))
            f, g, strides = modes.state_matrix, modes.input_matrix, controllability(gait, settings).strides
            z = np.random.default_rng(2).normal(size=modes.count)
            for count, reaches in ((strides, True), (strides - 1, False)):
                free = power(f, count) @ z
                reach = np.hstack([np.zeros((modes.count, 1)), *(power(f, i) @ g for i in range(count))])
                left = free - reach @ np.linalg.lstsq(reach, free)[0]
                assert (np.linalg.norm(left) < 1e-9) == reaches, (friction, settings, count)
                compared += 1
    assert compared == 30


# ---- dead-beat ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("friction", [0.2, 0.6])
@pytest.mark.parametrize("settings", [(ANGLE,), (ANGLE, TORQUE), (ANGLE, TORQUE, "hip.kp")])
def test_a_dead_beat_law_reaches_the_gait_and_its_error_falls_with_the_square(gaits, friction, settings):
    gait = gaits[friction]
    law = dead_beat(gait, settings)
    assert law.strides == 4 - len(settings)
    modes = lasting_modes(law.linearization)
    errors = []
    for size in SIZES[len(settings)] * np.array([4.0, 2.0, 1.0]):
        x = deviations(law, strides_under(law, away(gait, size), law.strides))
        errors.append(np.linalg.norm(modes.directions.T @ x[-1]))
    assert errors[-1] < 0.2 * SIZES[len(settings)]
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.1)
    assert errors[1] / errors[2] == pytest.approx(4.0, rel=0.1)


def test_a_mode_left_alone_keeps_its_eigenvalue(gaits):
    gait = gaits[0.6]
    law = dead_beat(gait, [ANGLE, TORQUE], negligible=0.05)
    assert law.strides == 1
    assert law.eigenvalues[0] == pytest.approx(gait.eigenvalues[2], rel=1e-9)
    assert abs(law.eigenvalues[1]) < 1e-6


def test_the_least_settings_reach_the_gait():
    """Two settings with the same effect share it: the law is that of least norm."""
    gait = find_gait()
    law = dead_beat(gait, [ANGLE, "control.touchdown_angle"])
    alone = dead_beat(gait, [ANGLE])
    assert np.asarray(law.gain) == pytest.approx(
        np.tile(0.5 * np.asarray(alone.gain), (2, 1)), rel=1e-6, abs=1e-12
    )


# ---- linear quadratic --------------------------------------------------------------------------------------


def test_the_regulator_is_the_limit_of_the_recursion_backwards_in_time(gaits):
    """An independent derivation: dynamic programming over more and more strides."""
    model = linearize(gaits[0.2], [ANGLE, TORQUE])
    a, b, r = model.state_matrix, model.input_matrix, np.diag([1.0, 0.1])
    cost = np.eye(6)
    for _ in range(500):
        gain = -np.linalg.solve(r + b.T @ cost @ b, b.T @ cost @ a)
        cost = np.eye(6) + gain.T @ r @ gain + (a + b @ gain).T @ cost @ (a + b @ gain)
    assert riccati_gain(a, b, np.eye(6), r)[0] == pytest.approx(gain, rel=1e-8, abs=1e-10)
    law = lqr(gaits[0.2], [ANGLE, TORQUE], input_weight=[1.0, 0.1])
    assert pytest.approx(cost, rel=1e-8, abs=1e-10) == law.S and np.array_equal(law.K, -np.asarray(law.gain))
    closed = a - b @ model.over_scales(law.K)
    assert np.sort(np.abs(np.linalg.eigvals(closed))) == pytest.approx(np.sort(np.abs(law.E)), abs=1e-12)


# ---- poles -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("settings", [(ANGLE,), (ANGLE, TORQUE), (ANGLE, TORQUE, "hip.kd")])
@pytest.mark.parametrize("wanted", [(0.5, -0.3, 0.1), (0.6, 0.2 + 0.3j, 0.2 - 0.3j)])
def test_placed_eigenvalues_are_those_of_the_closed_loop_by_differences_through_the_engine(
    gaits, settings, wanted
):
    gait = gaits[0.6]
    law = place_poles(gait, settings, wanted)
    for value in wanted:
        assert np.abs(law.eigenvalues - value).min() < 1e-9
    moved = 1e-7 * np.vstack([np.diag(gait.runner.scales), -np.diag(gait.runner.scales)])
    run = tdmf_slip.stride_map(gait.runner, gait.apex + moved, law=law, tolerance=1e-13)
    ends = run["next_apex"].values[:, 0] / gait.runner.scales
    found = np.linalg.eigvals((ends[:6] - ends[6:]).T / 2e-7)
    for value in wanted:
        assert np.abs(found - value).min() < 1e-4


@pytest.mark.parametrize("wanted", [(0.5, -0.2, 0.01), (0.1 + 0.2j, 0.1 - 0.2j, 0.05)])
def test_gains_do_not_depend_on_rounding(gaits, wanted):
    gait, random = gaits[0.6], np.random.default_rng(0)
    law = place_poles(gait, [ANGLE, TORQUE], wanted)
    for _ in range(10):
        moved = gait.jacobian * (1 + 1e-13 * random.normal(size=gait.jacobian.shape))
        other = place_poles(dataclasses.replace(gait, jacobian=moved), [ANGLE, TORQUE], wanted)
        assert pytest.approx(law.K, rel=1e-8, abs=1e-10) == other.K


# ---- any runner --------------------------------------------------------------------------------------------


def drawn_runner(source):
    """Random runner: parameters within factors of 1.6 of the defaults, friction from 0.05 to 7."""
    usual = Runner()
    names = ("foot.mass", "leg.stiffness", "leg.damping", "gravity", TORQUE, "hip.kp", "hip.kd")
    factors = dict.fromkeys(names, 0.5)
    factors["ground.friction"] = 2.5
    drawn = {name: usual[name] * np.exp(source.uniform(-size, size)) for name, size in factors.items()}
    return {**drawn, ANGLE: source.uniform(0.5, 0.9), "hip.retraction_rate": source.uniform(-0.01, 0.01)}


def test_any_gait_is_held_stable_or_not():
    """A dead-beat law leaves less than 2 % of a deviation of 1e-6; a stride of the ensemble errs by 1e-11.

    The runners are 6 random ones, or 24 with --release.
    """
    source, held, unstable = np.random.default_rng(5), 0, 0
    for _ in range(DRAWN):
        try:
            gait = find_gait(drawn_runner(source))
        except RunError:
            continue
        assert lqr(gait, [ANGLE, TORQUE]).lambda_max < 1.0
        law = dead_beat(gait, [ANGLE, TORQUE])
        first = away(gait, 1e-6, held)
        run = tdmf_slip.stride_map(gait.runner, first, strides=law.strides + 1, law=law, tolerance=1e-13)
        assert np.abs(deviations(law, run["next_apex"].values[0, -1])).max() < 2e-8
        held, unstable = held + 1, unstable + (not gait.stable)
    assert held >= DRAWN // 2 and unstable >= DRAWN // 24


# ---- by the engine -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("roughness", [0.0, 1e-3])
@pytest.mark.parametrize("friction", [0.1, 10.0])
def test_noise_spreads_the_apices_as_the_lyapunov_equation_says(gaits, friction, roughness):
    """The sampling error of a covariance from n runners is sqrt((P_ii P_jj + P_ij^2) / n).

    That is 6 % of a variance with 500 of them, with --release 3 % with 2000.
    """
    gait, runners = gaits[friction], 2000 if RELEASE else 500
    noise = 2e-4 * gait.runner.scales
    law = dataclasses.replace(lqr(gait, [ANGLE, TORQUE], [1, 1, 0, 0, 0, 0], 0.1), noise=noise, seed=7)
    strides = 40 if friction < 1.0 else 12
    assert law.lambda_max**strides < 1e-4
    run = tdmf_slip.stride_map(
        gait.runner,
        np.tile(gait.apex, (runners, 1)),
        strides=strides,
        law=law,
        roughness=roughness,
        seed=3,
        instructions=instruction_sets()[-1],
    )
    found = np.cov(run["next_apex"].values[:, -1].T)
    expected = apex_covariance(law, roughness)
    variances = np.diag(expected)
    errors = np.sqrt((np.outer(variances, variances) + expected**2) / runners)
    assert np.abs((found - expected) / errors).max() < 5.0
    assert variances[0] >= (1.3 if roughness else 1.0) * apex_covariance(law)[0, 0]


# ---- what is refused ---------------------------------------------------------------------------------------

REFUSED = [
    *(
        (lambda gait, make=make, given=given: make(gait, given), says)
        for make in (dead_beat, lqr, controllability)
        for given, says in (
            ([THRUST], "leg.thrust cannot be lowered at this gait, whose thrust is 0 m"),
            (["leg.stiffness"], "'leg.stiffness' is not allowed; near matches: "),
            (["hip.touchdown"], "near matches: hip.touchdown_angle"),
            ([ANGLE, ANGLE], "hip.touchdown_angle is given twice"),
            ([], "one or more in a list"),
            (ANGLE, "one or more in a list"),
        )
    ),
    *(
        (lambda gait, options=options: lqr(gait, [ANGLE], **options), says)
        for options, says in (
            ({"limits": {TORQUE: (0, 1)}}, "'hip.stance_torque' is not allowed; allowed: hip.touchdown_ang"),
            ({"limits": {ANGLE: (0.7, 0.8)}}, "(0.7, 0.8) is not allowed"),
            ({"limits": {ANGLE: (-2.0, 0.8)}}, "two numbers within"),
            ({"limits": {ANGLE: (np.nan, 0.8)}}, "is not allowed"),
            ({"limits": {ANGLE: 0.1}}, "two finite numbers"),
            ({"limits": [1]}, "pairs of numbers by setting"),
            ({"state_weight": -1.0}, "state_weight = -1.0 is not allowed"),
            ({"state_weight": [1, 1]}, "6 of them, or a symmetric matrix of 6 by 6"),
            ({"state_weight": np.triu(np.ones((6, 6)))}, "symmetric"),
            ({"input_weight": 0.0}, "input_weight = 0.0 is not allowed"),
            ({"input_weight": "much"}, "input_weight = 'much' is not allowed"),
        )
    ),
    *(
        (lambda gait, wanted=wanted: place_poles(gait, [ANGLE], wanted), says)
        for wanted, says in (
            ((0.1, 0.2), "allowed: 3 numbers, one for each mode that lasts"),
            ((0.1, 0.2, "x"), "3 numbers"),
            ((0.1, 0.2, np.inf), "3 numbers"),
            ((0.1, 0.2, 0.3j), "in conjugate pairs"),
            ((0.1, 0.1, 0.3), "repeated"),
        )
    ),
    *(
        (lambda gait, bound=bound: dead_beat(gait, [ANGLE], negligible=bound), "negligible = ")
        for bound in (0.0, 1.0, "small", np.nan)
    ),
    (lambda gait: dead_beat(gait, [ANGLE], negligible=0.99), "no mode of this gait lasts longer"),
    (lambda gait: lqr(gait.apex, [ANGLE]), "a Gait"),
    (
        lambda gait: lqr(dataclasses.replace(gait, error=1e-3), [ANGLE]),
        "next apex is 0.001 of the scales away",
    ),
    (lambda gait: lqr(dataclasses.replace(gait, following=(gait.apex,)), [ANGLE]), "gait of 2 strides"),
    (
        lambda _: lqr(find_gait({"hip.liftoff_angle_factor": 0.0}), ["hip.liftoff_angle_factor"]),
        "hip.liftoff_angle_factor = 0 at this gait is at the end of its range",
    ),
    (lambda _: lqr(find_gait(model="reduced"), [ANGLE, "hip.kp"]), "hip.kp has no effect on the next apex"),
    (
        lambda gait: apex_covariance(dataclasses.replace(lqr(gait, [ANGLE]), eigenvalues=np.array([1.1]))),
        "grows without bound",
    ),
    (lambda gait: apex_covariance(gait), "a Feedback, as dead_beat, lqr and place_poles give"),
    (lambda gait: apex_covariance(lqr(gait, [ANGLE]), -1.0), "roughness"),
]


@pytest.mark.parametrize(("ask", "says"), REFUSED, ids=[says[:30] for _, says in REFUSED])
def test_what_is_not_allowed_gets_one_sentence(gaits, ask, says):
    with pytest.raises(InputError) as refused:
        ask(gaits[0.6])
    assert says in str(refused.value) and "\n" not in str(refused.value)
