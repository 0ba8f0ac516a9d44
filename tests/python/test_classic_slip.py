"""The classic SLIP on slopes and with retraction, against an integration by SciPy of its own.

The leg is a polar coordinate about the foot, time a root of the foot's height in flight.
"""

import math
from functools import partial

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from tdmf_slip import RunError
from tdmf_slip.library import classic_slip

MASS, STIFFNESS, LENGTH, GRAVITY = 80.0, 20000.0, 1.0, 9.81
ENERGY = 6000.0
CASES = [
    (math.radians(angle), math.radians(slope), math.radians(rate))
    for angle, slope, rate in [
        (40, 0, 0),
        (42, 0, 0),
        (40, -3, 0),
        (40, 5, 0),
        (44, 5, 0),
        (44, 0, 20),
        (46, 0, 20),
        (50, 0, 50),
        (46, 4, 15),
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
    gaits = classic_slip.fixed_points(angle, ground_slope=slope, retraction_rate=rate)
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


def test_steps_down_a_slope_gain_energy_and_up_a_slope_lose_it():
    """Without anything that gives energy back, both end."""
    for slope, sign in ((-3.0, 1.0), (3.0, -1.0)):
        angle = math.radians(42.0)
        parameters = classic_slip.slip(angle, ground_slope=math.radians(slope))
        height, energy, steps = 1.2, ENERGY, 0
        while steps < 100:
            step = classic_slip.step(parameters, height, energy)
            if step.outcome != classic_slip.FLIES:
                break
            expected = one_step(angle, math.radians(slope), 0.0, height, energy)
            assert (step.next_height, step.next_energy) == pytest.approx(expected[:2], rel=1e-10)
            assert sign * (step.next_energy - energy) > 0.0
            height, energy, steps = step.next_height, step.next_energy, steps + 1
        assert 2 <= steps < 100


def test_retraction_gives_gaits_to_angles_that_have_none():
    assert classic_slip.fixed_points(math.radians(46.0)) == []
    retracting = classic_slip.fixed_points(math.radians(46.0), retraction_rate=math.radians(20.0))
    assert [gait.stable for gait in retracting] == [True, False]


@pytest.mark.parametrize(("slope", "rate"), [(0, 0), (-3, 0), (5, 0), (0, 5), (3, 11)])
def test_two_gaits_meet_in_the_fold_and_beyond_it_there_is_none(slope, rate):
    its = {"ground_slope": math.radians(slope), "retraction_rate": math.radians(rate)}
    fold = classic_slip.fold(**its)
    assert fold.slope == pytest.approx(1.0, abs=1e-8)
    before, beyond = fold.angle - math.radians(0.1), fold.angle + math.radians(0.1)
    gaits = classic_slip.fixed_points(before, **its)
    assert len(gaits) == 2 and gaits[0].height < fold.height < gaits[1].height
    assert gaits[0].slope < 1.0 < gaits[1].slope
    assert classic_slip.fixed_points(beyond, **its) == []


def test_a_fold_that_is_not_there_is_refused():
    with pytest.raises(RunError, match="no fold of the classic SLIP was found at energy = 500 J"):
        classic_slip.fold(500.0)
    with pytest.raises(RunError, match="no fold"):
        classic_slip.fold(ground_slope=math.radians(50.0))


def test_faster_retraction_doubles_the_period():
    """At 49.1 degrees per second the slope of the map passes -1."""
    slopes = [
        classic_slip.fixed_points(math.radians(46.0), retraction_rate=math.radians(rate))[0].slope
        for rate in (49.0, 49.2)
    ]
    assert slopes[0] > -1.0 > slopes[1]
