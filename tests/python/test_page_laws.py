"""Laws of one's own, each a subclass of ten lines, beside an independent integration."""

import numpy as np
import pytest
from conftest import reference_gaits
from page_runs import COMPILER, CompiledPage, central_difference
from runner_pages import SECTION, section, word, world_of
from scipy.optimize import brentq
from scipy_strides import Stride, torque_of_gains

from c_core.hybrid import Model, cos, event, mode, parameter, sin, state
from c_core.pages.runner import PlainRunner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")


class OwnLaws(PlainRunner):
    """A runner with four laws of its own; each is a few lines."""

    stance_kp = parameter(0.05, "N.m/rad", "Gain on the stance angle")
    stance_kd = parameter(0.02, "N.m.s/rad", "Gain on the rate of the stance angle")
    hardening = parameter(3, "m-2", "The spring hardens with the cube of its compression")
    viscosity = parameter(0.3, "s/m", "Friction grows with the speed of the slip")
    amplitude = parameter(0.02, "N.m", "Torque that follows a clock")
    frequency = parameter(1.5, "rad/s", "Angular frequency of the clock")

    def stance_torque(r):
        leg = r.leg()
        servo = r.stance_kp * (leg.angle + 0.4) + r.stance_kd * leg.angle_rate
        return super().stance_torque() - servo + r.amplitude * sin(r.frequency * r.time)

    def spring(r):
        short = r.free_length - r.leg().length
        return super().spring() + r.stiffness * r.hardening * short**3

    def slip_friction(r):
        return super().slip_friction() + r.viscosity * r.way * r.foot_vx


GAINS = torque_of_gains(0.05, 0.02, -0.4)
LAWS = {
    "torque": lambda t, *at: GAINS(t, *at) + 0.02 * np.sin(1.5 * t),
    "spring": lambda short: short + 3 * short**3,
    "viscosity": 0.3,
}
SEEDS = [
    "stance_kp",
    "stance_kd",
    "hardening",
    "stiffness",
    "viscosity",
    "friction",
    "amplitude",
    "frequency",
]


def test_own_laws_agree_with_scipy_and_their_derivatives_with_differences():
    page = CompiledPage(OwnLaws, level="-O1")
    apex = next(gait for gait in reference_gaits(False) if gait["friction"] == 0.43)["apex"]
    world = world_of(apex)
    run = page.start(friction=0.43, tolerance=1e-13, **world).to(stop="apex")
    wanted = Stride(0.43, **LAWS).run(apex)
    assert word(run) == wanted["word"] and {"+", "-"} <= set(wanted["word"])
    assert section(run) == pytest.approx(wanted["apex"], abs=1e-9)
    assert (run.time, run.work) == pytest.approx((wanted["period"], wanted["work"]), abs=1e-9)
    world["seen_vy"] -= 0.02  # no apex to begin with
    seeds, ends = [*SEEDS, "seen_vx", "angle", "length_rate"], {}
    run = page.start(seeds=seeds, friction=0.43, tolerance=1e-14, **world).to(stop="apex")
    exact = np.array([run.d(name) for name in SECTION])
    for i, seed in enumerate(seeds):
        base = page.start(friction=0.43, **world)
        value, step = getattr(base, seed), 1e-5
        for sign in (2, 1, -1, -2):
            given = {"friction": 0.43, "tolerance": 1e-14, **world, seed: value + sign * step}
            ends[sign] = section(page.start(**given).to(stop="apex"))
        found = central_difference(ends, step)
        assert exact[:, i] == pytest.approx(found, abs=1e-7 * (1 + np.abs(exact[:, i]).max()))


class SpinningLeg(Model):
    """A mass that falls while its leg turns steadily: its states are polynomials, its guards are not."""

    start = "fall", {}
    turn, gravity = parameter(1, "rad/s"), parameter(0.009, "m/s2")
    length, height, speed = parameter(1, "m"), state(1, "m"), state(0, "m/s")
    angle, first = state(1.15, "rad"), state(0)

    @mode()
    def fall(s):
        return {"height": s.speed, "speed": -s.gravity, "angle": -s.turn}

    @mode(ends=True)
    def done(s):
        return {}

    @event("fall", when=lambda s: s.height + 0.15 * s.length * cos(s.angle), unit="m")
    def body_lands(s):
        return s.to("done", first=1)

    @event("fall", when=lambda s: s.height - 0.85 * s.length * cos(s.angle), unit="m")
    def foot_lands(s):
        return s.to("done", first=2)


@pytest.fixture(scope="module")
def spinning():
    return CompiledPage(SpinningLeg)


@pytest.mark.parametrize("turn", [0.0004, 0.01, 1.0, 30.0])
@pytest.mark.parametrize("until", [1e2, 1e4, 1e6, 1e9, 1e12, 1e30])
def test_a_leg_that_spins_steadily_meets_its_first_event_however_far_a_run_goes(spinning, turn, until):
    def above(time):
        return 1 - 0.0045 * time**2 - 0.85 * np.cos(1.15 - turn * time)

    times = np.linspace(0, 15, 200001)
    at = np.argmax(above(times) < 0)
    run = spinning.start(turn=turn, tolerance=1e-13).to(until)
    assert (run.outcome, run.first) == ("ended", 2)
    assert run.time == pytest.approx(brentq(above, *times[at - 1 : at + 1], xtol=1e-14), abs=1e-11)
    assert run.run.steps < 200
