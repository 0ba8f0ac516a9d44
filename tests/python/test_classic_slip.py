"""The classic SLIP beside references, what its physics says, and an integration by SciPy of its own.

In that integration, the leg is a polar coordinate about the foot, and touchdown a root of the foot's height.
"""

import math
from collections import Counter
from functools import partial
from itertools import product

import numpy as np
import pytest
from references import read
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from tdmf_slip import Batch, InputError, RunError
from tdmf_slip.library import classic_slip
from tdmf_slip.library.classic_slip import ENERGY, NO_SLIP, slip, step
from tdmf_slip.library.page_strides import seeds_of, strides_of
from tdmf_slip.paper.evidence import lowest_stable_angle

MASS, STIFFNESS, LENGTH, GRAVITY = 80.0, 20000.0, 1.0, 9.81
STEPS = read("classic_steps.json")
"""Random steps by an earlier solver for this runner alone: flight in closed form, Taylor series in stance."""
CASES = [
    (math.radians(angle), math.radians(slope), math.radians(rate))
    for angle, slope, rate in [
        (40, 0, 0),
        (44, 5, 0),
        (46, 0, 20),
        (42, -4, 10),
    ]
]


def stance(time, state):
    """Theta of (r, theta, their rates) counts from the vertical and is positive with the foot ahead."""
    r, theta, r_rate, theta_rate = state
    spring = STIFFNESS / MASS * (LENGTH - r)
    return [
        r_rate,
        theta_rate,
        r * theta_rate**2 + spring - GRAVITY * math.cos(theta),
        (GRAVITY * math.sin(theta) - 2.0 * r_rate * theta_rate) / r,
    ]


def relaxed(time, state):
    return state[0] - LENGTH


relaxed.terminal = True
relaxed.direction = 1.0


def touchdown(angle, slope, rate, height, speed):
    """The first instant after an apex at which the foot is on the ground."""

    def above(time):
        leg = angle - rate * time
        foot = speed * time + LENGTH * math.sin(leg)
        return height - GRAVITY * time**2 / 2 - LENGTH * math.cos(leg) - foot * math.tan(slope)

    times = np.linspace(0.0, 3.0, 3001)
    first = next(i for i, time in enumerate(times) if above(time) < 0.0)
    return brentq(above, times[first - 1], times[first], xtol=1e-15)


def one_step(angle, slope, rate, height, energy=ENERGY):
    """Next height and energy above the ground, and the length of the step."""
    speed = math.sqrt(2.0 * (energy / MASS - GRAVITY * height))
    time = touchdown(angle, slope, rate, height, speed)
    leg = angle - rate * time
    foot, fall = speed * time + LENGTH * math.sin(leg), -GRAVITY * time
    along = -speed * math.sin(leg) + fall * math.cos(leg)
    across = -speed * math.cos(leg) - fall * math.sin(leg)
    start = [LENGTH, leg, along, across / LENGTH]
    run = solve_ivp(stance, (0.0, 5.0), start, "DOP853", events=relaxed, rtol=1e-13, atol=1e-14)
    r, theta, r_rate, theta_rate = run.y_events[0][-1]
    vx = -r_rate * math.sin(theta) - r * theta_rate * math.cos(theta)
    vy = r_rate * math.cos(theta) - r * theta_rate * math.sin(theta)
    assert vy > 0.0
    x = foot - r * math.sin(theta) + vx * vy / GRAVITY
    top = (foot * math.tan(slope)) + r * math.cos(theta) + vy**2 / (2.0 * GRAVITY) - x * math.tan(slope)
    return top, MASS * (vx**2 / 2.0 + GRAVITY * top), x


@pytest.mark.parametrize("case", CASES)
def test_a_gait_repeats_its_height_and_its_slope_is_that_of_the_map(case):
    angle, slope, rate = case
    gaits = classic_slip.classic_gaits(angle, ground_slope=slope, retraction_rate=rate)
    assert gaits and gaits[0].stable == (abs(gaits[0].slope) < 1.0)
    for gait in gaits:
        height, energy, length = one_step(*case, gait.height)
        assert height == pytest.approx(gait.height, abs=1e-10)
        assert length == pytest.approx(gait.length, abs=1e-9)
        assert energy == pytest.approx(ENERGY - gait.energy_loss, abs=1e-7)
        assert gait.energy_loss == pytest.approx(MASS * GRAVITY * length * math.tan(slope), abs=1e-7)
        of_height = partial(one_step, *case)
        small = 1e-4
        ahead, behind = of_height(gait.height + small)[0], of_height(gait.height - small)[0]
        assert gait.slope == pytest.approx((ahead - behind) / (2.0 * small), abs=1e-6 * gait.slope**2 + 1e-6)


@pytest.mark.parametrize(("slope", "rate"), [(0, 0), (3, 11)])
def test_two_gaits_meet_in_the_fold_and_beyond_it_there_is_none(slope, rate):
    its = {"ground_slope": math.radians(slope), "retraction_rate": math.radians(rate)}
    fold = classic_slip.classic_fold(**its)
    assert fold.slope == pytest.approx(1.0, abs=1e-8)
    before, beyond = fold.angle - math.radians(0.1), fold.angle + math.radians(0.1)
    gaits = classic_slip.classic_gaits(before, **its)
    assert len(gaits) == 2 and gaits[0].height < fold.height < gaits[1].height
    assert gaits[0].slope < 1.0 < gaits[1].slope
    assert classic_slip.classic_gaits(beyond, **its) == []


def test_the_paper_s_slip_is_stable_from_a_period_doubling_to_a_fold():
    """Their angles are 31.28 and 44.59 degrees; by SciPy, the slope of the map at the former is -1."""
    angles = lowest_stable_angle(), classic_slip.classic_fold().angle
    assert np.degrees(angles) == pytest.approx([31.28, 44.59], abs=5e-3)

    def ahead(height):
        return one_step(angles[0], 0.0, 0.0, height)[0]

    low = brentq(lambda height: ahead(height) - height, LENGTH * math.cos(angles[0]) + 1e-3, 1.0, xtol=1e-12)
    assert (ahead(low + 1e-5) - ahead(low - 1e-5)) / 2e-5 == pytest.approx(-1.0, abs=1e-4)


def test_a_fold_that_is_not_there_is_refused():
    with pytest.raises(RunError, match="no fold of the classic SLIP was found at energy = 500 J"):
        classic_slip.classic_fold(500.0)
    with pytest.raises(RunError, match="no fold"):
        classic_slip.classic_fold(ground_slope=math.radians(50.0))


def test_faster_retraction_doubles_the_period():
    """The slope of the map passes -1 at 49.1 degrees per second. Without retraction there is no gait."""
    assert classic_slip.classic_gaits(math.radians(46.0)) == []
    slopes = [
        classic_slip.classic_gaits(math.radians(46.0), retraction_rate=math.radians(rate))[0].slope
        for rate in (49.0, 49.2)
    ]
    assert slopes[0] > -1.0 > slopes[1]


@pytest.mark.parametrize(
    ("angle", "heights", "slopes", "friction"),
    [
        (40, (1.03696, 3.54806), (-0.0603, 3.7622), 4.939),
        (42, (1.17889, 3.06865), (0.1626, 2.7634), 3.852),
        (44, (1.50393, 2.40934), (0.5428, 1.6600), 2.798),
    ],
)
def test_gaits_are_those_of_the_reference(angle, heights, slopes, friction):
    """All digits of the reference but the last are trusted."""
    gaits = classic_slip.classic_gaits(math.radians(angle))
    assert [gait.height for gait in gaits] == pytest.approx(heights, abs=1.5e-5)
    assert [gait.slope for gait in gaits] == pytest.approx(slopes, abs=1.5e-4)
    assert gaits[0].impact_friction == pytest.approx(friction, abs=1.5e-3)
    assert gaits[0].stance_friction == pytest.approx(math.tan(math.radians(angle)), abs=1e-11)


def drawn(number):
    """A runner's parameters, its energy and apex height."""
    random = np.random.default_rng([473, number])
    u = random.uniform
    parameters = {
        "mass": 80 * 2 ** u(-1, 1), "stiffness": 20000 * 2 ** u(-1, 1), "free_length": u(0.8, 1.2),
        "gravity": u(5, 12),
        "angle": u(-0.2, 1.1), "friction": NO_SLIP if u() < 0.4 else 10 ** u(-0.7, 0.5),
        "ground_slope": u(-0.2, 0.2) if u() < 0.6 else 0.0, "retraction_rate": u(-1, 2) if u() < 0.6 else 0.0,
    }  # fmt: skip
    height = parameters["free_length"] * u(0.7, 2.5)
    energy = parameters["mass"] * (parameters["gravity"] * height + u(-1, 8) ** 2 / 2 * np.sign(u(-0.1, 1)))
    return parameters, max(0.0, energy), height


def test_random_steps_are_those_of_another_solver():
    seeds = ["touchdown_angle", "slope", "retraction_rate"]
    for number, (outcome, *values) in enumerate(STEPS):
        given, energy, height = drawn(number)
        runner = slip(**given)
        made = step(runner, height, energy)
        assert made.outcome == outcome, number
        if not values:
            continue
        early, *quantities = values[:8]
        found = (made.next_height, made.next_energy, made.next_speed, made.stance_time, made.stance_friction,
                 made.impact_friction, made.length)  # fmt: skip
        assert (made.early_take_off, *found) == (
            early,
            *(pytest.approx(q, rel=1e-9, abs=1e-9) for q in quantities),
        ), number
        if not early:
            columns = Batch(runner, [height, energy]).stride(along=seeds).next_apex_by
            expected = np.array(values[8:]).T
            off = np.abs(columns - expected) / (1 + np.abs(expected).max(axis=1, keepdims=True))
            assert off.max() < 1e-8, number
    found = Counter(outcome for outcome, *_ in STEPS)
    assert len(found) == 5 and min(found.values()) > 25


@pytest.mark.parametrize("early", [False, True])
def test_derivatives_are_those_of_differences(early):
    """Derivatives are exact, even where the leg leaves the friction cone."""
    given = {
        "touchdown_angle": 0.65,
        "slope": 0.03,
        "retraction_rate": 0.3,
        "stiffness": 20000.0,
        "mass": 80.0,
    }
    given["friction"] = 0.7 if early else NO_SLIP
    point, size = np.array([1.3, 4000.0]), 1e-6
    seeds = ["slope", "stiffness", "mass", "touchdown_angle", "retraction_rate", *["friction"] * early]
    names = ("apex_height", "apex_energy", "step_length")

    def run(at, given):
        runner = slip(given["touchdown_angle"], ground_slope=given["slope"], **without(given))
        of = runner.model
        made = strides_of(
            of,
            runner.parameters,
            runner.states,
            at[None],
            tolerance=runner.tolerance,
            seeds=seeds_of(of, seeds),
        )
        assert made.outcome[0] == 0 and made.states[0, of.state_numbers["left_early"]] == early
        columns = [of.state_numbers[name] for name in names]
        return made.states[0, columns], made.d_states[0][:, columns].T

    def without(given):
        return {name: value for name, value in given.items() if name not in ("touchdown_angle", "slope")}

    def ends(change, by):
        changed = given | ({change: given[change] * (1 + by)} if isinstance(change, str) else {})
        at = point if isinstance(change, str) else point * (1 + by * np.eye(2)[change])
        return run(at, changed)[0]

    for column, change in zip(run(point, given)[1].T, [0, 1, *seeds], strict=True):
        by = given[change] if isinstance(change, str) else point[change]
        found = (ends(change, size) - ends(change, -size)) / (2 * size)
        assert column * by / [1, 4000, 1] == pytest.approx(found / [1, 4000, 1], abs=1e-6, rel=1e-5), change


def take_off(runner, height, energy):
    made = step(runner, height, energy)
    return classic_slip.path(runner, height, made.touchdown_time + made.stance_time, energy)[:, 0]


def energy_of(at):
    """Energy of the paper's SLIP in stance, by position and velocity relative to the foot."""
    x, y, vx, vy = at
    return MASS * ((vx**2 + vy**2) / 2 + GRAVITY * y) + STIFFNESS * (LENGTH - np.hypot(x, y)) ** 2 / 2


@pytest.mark.parametrize("slope", [-10, 0, 5])
def test_energy_is_kept_and_time_can_be_turned(slope):
    """The step backward lands where this step took off, on the slope that rises where this one falls."""
    slope, turned = math.radians(slope), 0
    for angle in np.radians(np.arange(20, 50, 3)):
        runner = slip(angle, ground_slope=slope)
        made = step(runner, 1.4)
        times = made.touchdown_time + np.linspace(0, made.stance_time, 11)
        energies = energy_of(classic_slip.path(runner, 1.4, times))
        assert energies == pytest.approx(energies[0], rel=1e-12)
        if made.outcome != "flies":
            continue
        x, y, *_ = take_off(runner, 1.4, ENERGY)
        back = step(slip(math.atan2(x, y), ground_slope=-slope), made.next_height, made.next_energy)
        if back.outcome == "no start":  # the foot would be below the ground at the apex
            continue
        assert (back.next_height, back.length) == pytest.approx((1.4, made.length), abs=1e-10)
        assert (back.next_energy, back.stance_time) == pytest.approx((ENERGY, made.stance_time), rel=1e-10)
        turned += 1
    assert turned >= 3


def test_a_leg_that_would_lengthen_from_touchdown_on_takes_off_at_once_and_falls():
    """A leg that lands upright or behind may do so, and otherwise keeps the energy of its step."""
    found = Counter()
    for angle, speed in product(np.radians(np.arange(-40, 1, 2)), np.arange(0.1, 4, 0.2)):
        energy = MASS * (speed**2 / 2 + GRAVITY * 1.2)
        made = step(slip(angle), 1.2, energy)
        x, y, vx, vy = classic_slip.path(slip(angle), 1.2, made.touchdown_time, energy)[:, 0]
        lengthens = x * vx + y * vy > 0
        if lengthens:
            assert made.outcome == "falls" and made.stance_time < 1e-6
        elif made.outcome == "flies":
            assert made.next_energy == pytest.approx(energy, rel=1e-12)
        found["lengthens" if lengthens else made.outcome] += 1
    assert found["flies"] >= 1 and found["lengthens"] >= 5


def test_friction_is_needed_where_the_leg_turns_back():
    """The mass of a slow runner does not get over the foot, and falls back behind it."""
    energy = MASS * (0.2**2 / 2 + GRAVITY * 1.35)
    made = step(slip(0.2), 1.35, energy)
    times = made.touchdown_time + np.linspace(0, made.stance_time, 2000)
    x, y, *_ = classic_slip.path(slip(0.2), 1.35, times, energy)
    steepest = np.abs(x / y).max()
    assert x[-1] < 0 and made.stance_friction == pytest.approx(steepest, abs=1e-6)
    ends = [step(slip(0.2, of * steepest), 1.35, energy).outcome for of in (0.99, 1.01)]
    assert (made.outcome, ends) == ("turns back", ["slides", "turns back"])


def test_retraction_is_an_angle_that_depends_on_the_fall():
    """A leg that retracts makes the same step as one held at the angle at which it lands."""
    for rate in np.arange(-0.2, 0.7, 0.2):
        given = {"ground_slope": math.radians(6)}
        made = step(slip(math.radians(44), retraction_rate=rate, **given), 1.5)
        held = step(slip(math.radians(44) - rate * made.touchdown_time, **given), 1.5)
        assert made.outcome == held.outcome == "flies"
        assert (made.next_height, made.length) == pytest.approx((held.next_height, held.length), abs=1e-11)


@pytest.mark.parametrize("slope", [0, 12])
def test_friction_ends_a_stance_in_two_ways(slope):
    """Figure 3 of the paper. The leg's angle counts from the normal of the ground."""
    slope, angle = math.radians(slope), math.radians(30)
    at_touchdown = math.tan(angle - slope)
    held = slip(angle, 0.99 * at_touchdown, ground_slope=slope)
    assert step(held, 1.3).outcome == "slides"
    needed = step(slip(angle, ground_slope=slope), 1.3).stance_friction
    assert needed > 1.1 * at_touchdown
    early = slip(angle, 0.95 * needed, ground_slope=slope)
    made = step(early, 1.3)
    x, y, *_ = at = take_off(early, 1.3, ENERGY)
    assert made.early_take_off
    assert math.tan(math.atan2(x, y) + slope) == pytest.approx(0.95 * needed, abs=1e-12)
    assert made.stance_friction == pytest.approx(0.95 * needed, abs=1e-12)
    left = STIFFNESS * (LENGTH - math.hypot(x, y)) ** 2 / 2
    whole = energy_of(classic_slip.path(early, 1.3, made.touchdown_time)[:, 0])
    assert left > 0 and energy_of(at) == pytest.approx(whole, rel=1e-12)
    climbed = MASS * GRAVITY * made.length * math.tan(slope)
    assert made.next_energy == pytest.approx(ENERGY - climbed - left, rel=1e-12)


def test_steps_that_cannot_begin_or_land():
    assert step(slip(math.radians(40)), 0.5).outcome == "no start"
    assert step(slip(math.radians(40)), 100.0).outcome == "no start"
    assert step(slip(math.radians(40), ground_slope=0.99), 1.3).outcome == "no start"
    assert step(slip(math.radians(80), retraction_rate=-20), 1.3).outcome == "falls"
    for name, value, allowed in [
        ("mass", math.nan, "1e-09 to 1e\\+09 kg"),
        ("friction", -1.0, "0 to 1e\\+09"),
        ("ground_slope", 1.0, "-1 to 1"),
        ("retraction_rate", math.inf, "-1e"),
    ]:
        shown = name.removeprefix("ground_")
        with pytest.raises(InputError, match=f"{shown} = {value} is not allowed; allowed: {allowed}"):
            slip(0.7, **{name: value})
    for height, energy in ((1.0, math.nan), (math.inf, ENERGY)):
        with pytest.raises(InputError, match="allowed: finite numbers"):
            step(slip(0.7), height, energy)
