"""Tests of the prover itself: gaits with known answers, other steps, laws that are broken on purpose."""

import pickle
from types import SimpleNamespace as Record

import pytest
import tdmf_slip
from conftest import CLAMPED, some_of
from references import read

pytest.importorskip("flint")

from flint import arb, ctx
from tdmf_slip.proof import flow as flow_module
from tdmf_slip.proof import travelling_set
from tdmf_slip.proof.dual import UndecidedError
from tdmf_slip.proof.guards import Guard
from tdmf_slip.proof.laws import Motion
from tdmf_slip.proof.parameters import Mode
from tdmf_slip.proof.travelling_set import VariedFlow

PROVED = read("proved_gaits.json")
KNOWN = {gait["friction"]: gait for gait in PROVED["gaits"]}
SHORT, LONG = "10", "0.2"
"""Friction of a gait that is proved fast, and of one that has all laws in it."""
BITS, DEGREE = 128, 40
PLANE = Record(
    slope=arb(0), longest_step=0.5, sizes={}, swing_frequency=1.0, is_varied=False, falls_with_speed=False
)
"""Stand-in for a runner, for systems of the plane: `length` is position, `length_rate` velocity."""


def plane(monkeypatch, acceleration):
    """Steps that follow  x'' = acceleration(x, x')  in the place of a runner's motion."""

    def rates(runner, mode, values):
        return {
            **{
                "length": values["length_rate"],
                "length_rate": acceleration(values["length"], values["length_rate"]),
            },
            **{name: arb(0) for name in ("angle", "angle_rate", "sine", "cosine")},
        }

    for module in (flow_module, travelling_set):
        monkeypatch.setattr(module, "rates", rates)


def half_turn(position):
    """Time and place of the next rest after rest at a positive position; slope of that place by the start."""
    start = {"length": position, "angle": arb(0), "length_rate": arb(0), "angle_rate": arb(0)}
    time, slopes, order = arb(0), None, 1
    while True:
        step = VariedFlow(PLANE, Mode("stick"), start, DEGREE)
        step.vary(PLANE)
        guard = Guard("rest", -step.tubes["length_rate"], order)
        order, end = 0, step.reach
        rest = guard.zero_after(arb(0), end) if guard.reached(arb(0), end) is not None else None
        derivative = step.matrix(end if rest is None else rest)
        slopes = derivative if slopes is None else derivative * slopes
        if rest is not None:  # the section is met at rest, so that a later meeting does not move it
            return time + rest, step.tubes["length"].at(rest), slopes[0, 0]
        time, start = time + end, step.at(end)


def test_the_harmonic_oscillator_has_its_period(monkeypatch):
    plane(monkeypatch, lambda x, v: -x)
    with ctx.workprec(BITS):
        time, position, slope = half_turn(arb(1))
        assert time.overlaps(arb.pi())
        assert position.contains(-1)
        assert slope.contains(-1)
        assert all(ball.rad() < 1e-20 for ball in (time, position, slope))


def test_the_orbit_of_van_der_pol_is_proved_with_its_known_size_and_period(monkeypatch):
    """Known from series in Python's decimals of 40 digits; half a gait turned over is the other half."""
    plane(monkeypatch, lambda x, v: (1 - x * x) * v - x)
    with ctx.workprec(BITS):
        size, period = (
            arb(f"[{known} +/- 1e-29]")
            for known in ("2.00861986087484313650964018836", "6.66328685932313018969968203048")
        )
        centre, radius = size.mid(), arb("1e-15")
        _, position, _ = half_turn(centre)
        _, _, slope = half_turn(centre + arb(0, radius))
        steepness = -slope - 1  # of where the next half turn begins, less where this one did
        away = (-position - centre) / steepness
        assert abs(away) < radius  # Newton's interval operator: there is exactly one
        assert (centre - away).overlaps(size)
        time, _, _ = half_turn(centre - away)
        assert (2 * time).overlaps(period)
        assert time.rad() < 1e-25
        assert abs(slope) < 1  # and it attracts


def test_steps_of_other_lengths_enclose_the_same(monkeypatch):
    """Both tubes hold the ends of all starts within 1e-8, so they overlap."""
    longest = flow_module.longest

    def tube(share):
        monkeypatch.setattr(flow_module, "longest", lambda *given: (longest(*given) * share).mid())
        return travelling_set.tube_along({"ground.friction": SHORT, **CLAMPED})

    one, other = tube(arb(1)), tube(arb("0.7"))
    assert len(one) < len(other)
    for name, middle in one[-1].middle.items():
        radius = one[-1].radius[name] + other[-1].radius[name]
        assert abs(middle - other[-1].middle[name]) <= radius and 0 < radius < 1e-5, name


LAWS = {"spring": SHORT, "servo": SHORT, "slip_friction": LONG, "speed_left": LONG, "grazing_across": LONG}
"""Laws, with the friction of a gait in which each matters."""


@pytest.mark.parametrize(("law", "friction"), some_of(LAWS.items(), 1))
def test_a_law_that_is_wrong_by_a_part_in_1e12_is_noticed(monkeypatch, law, friction):
    """The first of the laws, or with --release all five."""
    right = getattr(Motion, law)
    with ctx.workprec(400):
        factor = 1 + arb(10) ** -12
    monkeypatch.setattr(Motion, law, lambda *given: right(*given) * factor)
    proof = tdmf_slip.prove({"ground.friction": friction, **CLAMPED}, digits=12)
    assert proof.proved
    with ctx.workprec(200):
        assert not arb(proof.as_json()["period"]).overlaps(arb(KNOWN[friction]["period"]))


@pytest.mark.parametrize("ball", [arb(0), arb(0, 1e-5), arb(3), -arb.pi(), arb(0, 1)])
def test_balls_are_pickled_exactly(ball):
    again = pickle.loads(pickle.dumps(ball))
    assert again.mid().man_exp() == ball.mid().man_exp()
    assert again.rad().man_exp() == ball.rad().man_exp()


def test_what_is_not_finite_stays_so():
    assert not pickle.loads(pickle.dumps(arb("inf"))).is_finite()
    assert not pickle.loads(pickle.dumps(arb("nan"))).is_finite()


def test_a_motion_without_bounds_is_undecided(monkeypatch):
    plane(monkeypatch, lambda x, v: x / (x - x))
    with ctx.workprec(BITS), pytest.raises(UndecidedError, match="motion"):
        half_turn(arb(1))
