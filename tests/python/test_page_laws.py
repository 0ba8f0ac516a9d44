"""Laws of one's own, each a subclass of ten lines, beside an independent integration."""

import numpy as np
import pytest
from conftest import reference_gaits
from independent_runner import Stride, torque_of_gains
from page_runs import COMPILER, CompiledPage, central_difference
from scipy.optimize import brentq
from test_page_runner import SECTION, section, world_of

from c_core.hybrid import Model, cos, event, mode, parameter, sin, state
from c_core.pages.runner import PlainRunner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")


class StanceGains(PlainRunner):
    """A proportional-derivative gain on the stance angle."""

    stance_kp = parameter(0.05, "N.m/rad")
    stance_kd = parameter(0.02, "N.m.s/rad")

    def stance_torque(r):
        leg = r.leg()
        return super().stance_torque() - r.stance_kp * (leg.angle + 0.4) - r.stance_kd * leg.angle_rate


class HardSpring(PlainRunner):
    """A spring that hardens with the cube of its compression."""

    hardening = parameter(3, "m-2")

    def spring(r):
        short = r.free_length - r.leg().length
        return super().spring() + r.stiffness * r.hardening * short**3


class ViscousSlip(PlainRunner):
    """Friction that grows with the speed of the slip."""

    viscosity = parameter(0.3, "s/m")

    def slip_friction(r):
        return super().slip_friction() + r.viscosity * r.way * r.foot_vx


class Clock(PlainRunner):
    """A torque that follows a clock."""

    amplitude, frequency = parameter(0.02, "N.m"), parameter(1.5, "rad/s")

    def stance_torque(r):
        return super().stance_torque() + r.amplitude * sin(r.frequency * r.time)


LAWS = [
    (
        StanceGains,
        {"torque": torque_of_gains(0.05, 0.02, -0.4)},
        ["stance_kp", "stance_kd"],
    ),
    (HardSpring, {"spring": lambda short: short + 3 * short**3}, ["hardening", "stiffness"]),
    (ViscousSlip, {"viscosity": 0.3}, ["viscosity", "friction"]),
    (
        Clock,
        {"torque": lambda t, angle, turn, drives: -0.2 * drives + 0.02 * np.sin(1.5 * t)},
        ["amplitude", "frequency"],
    ),
]


@pytest.mark.parametrize(("model", "laws", "seeds"), LAWS, ids=[law[0].__name__ for law in LAWS])
def test_a_law_of_ten_lines_agrees_with_scipy_and_its_derivatives_with_differences(model, laws, seeds):
    page = CompiledPage(model, level="-O1")
    world = world_of(next(gait for gait in reference_gaits(False) if gait["friction"] == 0.43)["apex"])
    run = page.start(friction=0.43, tolerance=1e-13, **world).to(stop="apex")
    time, apex, work = Stride(0.43, **laws).run(world)
    assert run.time == pytest.approx(time, abs=1e-9)
    assert section(run) == pytest.approx(apex, abs=1e-9)
    assert run.work == pytest.approx(work, abs=1e-9)
    world["seen_vy"] -= 0.02  # no apex to begin with
    seeds, ends = [*seeds, "seen_vx", "angle", "length_rate"], {}
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
