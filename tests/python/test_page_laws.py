"""Laws of one's own, each a subclass of ten lines, beside an independent integration."""

import numpy as np
import pytest
from conftest import reference_gaits
from independent_runner import Stride
from page_runs import COMPILER, CompiledPage
from test_page_runner import SECTION, section, world_of

from c_core.hybrid import parameter, sin
from c_core.pages.runner import PlainRunner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
STATES = ["seen_x", "seen_y", "length", "angle", "seen_vx", "seen_vy", "length_rate", "angle_rate"]


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
        {"torque": lambda t, angle, turn, drives: -0.2 * drives - 0.05 * (angle + 0.4) - 0.02 * turn},
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
    time, apex, work = Stride(0.43, **laws).run([world[name] for name in STATES])
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
        found = (8 * (ends[1] - ends[-1]) - (ends[2] - ends[-2])) / (12 * step)
        assert exact[:, i] == pytest.approx(found, abs=1e-7 * (1 + np.abs(exact[:, i]).max()))
