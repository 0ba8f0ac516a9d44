"""The laws that proofs are made with, against the C library's at random points."""

import math

import numpy as np
import pytest
from tdmf_slip.library.binding import c, ffi
from tdmf_slip.library.runner import Runner
from tdmf_slip.variables.table import STATES

pytest.importorskip("flint")

from types import SimpleNamespace as Record

from flint import arb, ctx
from tdmf_slip.proof import laws
from tdmf_slip.proof.flow import fall, with_helpers
from tdmf_slip.proof.given import exact_values
from tdmf_slip.proof.guards import FUNCTIONS, watched
from tdmf_slip.proof.parameters import Mode, Parameters, names_of
from tdmf_slip.proof.transitions import Transition

POINTS = 1000
CONTACTS = {
    "flight": c.TDMF_CONTACT_FLIGHT,
    "stick": c.TDMF_CONTACT_STICK,
    "graze": c.TDMF_CONTACT_GRAZE,
    1: c.TDMF_CONTACT_SLIP_POSITIVE,
    -1: c.TDMF_CONTACT_SLIP_NEGATIVE,
}
GUARDS = {
    "touchdown": (c.TDMF_GUARD_TOUCHDOWN, "length"),
    "apex": (c.TDMF_GUARD_APEX, "speed"),
    "clamp": (c.TDMF_GUARD_CLAMP, "energy"),
    "lift-off": (c.TDMF_GUARD_LIFT_OFF, "force"),
    "slip onset forwards": (c.TDMF_GUARD_SLIP_ONSET_POSITIVE, "force"),
    "slip onset backwards": (c.TDMF_GUARD_SLIP_ONSET_NEGATIVE, "force"),
    "end of slip": (c.TDMF_GUARD_SLIP_VELOCITY_ZERO, "speed"),
    "mid-stance": (c.TDMF_GUARD_MID_STANCE, None),
    "greatest compression": (c.TDMF_GUARD_GREATEST_COMPRESSION, "speed"),
    "load": (c.TDMF_GUARD_GRAZE_TO_CONTACT, "force"),
    "flight": (c.TDMF_GUARD_GRAZE_TO_FLIGHT, "force"),
    "the body's height": (c.TDMF_GUARD_BODY_DOWN, "length"),
    "the leg's length": (c.TDMF_GUARD_LEG_TOO_SHORT, "length"),
}


@pytest.fixture(autouse=True)
def quadruple():
    with ctx.workprec(113):
        yield


class Point:
    """A random runner in a random mode, as both texts take it."""

    def __init__(self, rng, contact=None, sign=0):
        draw = rng.uniform
        self.given = {
            "body.mass": draw(0.5, 2),
            "foot.mass": draw(0.01, 1),
            "leg.stiffness": draw(0.5, 2),
            "leg.damping": draw(0, 1),
            "gravity": draw(0.01, 1),
            "hip.stance_torque": draw(-0.5, 0.5),
            "hip.touchdown_angle": draw(-1, 1),
            "hip.kp": draw(0.01, 1),
            "hip.kd": draw(0.01, 1),
            "hip.liftoff_angle_factor": draw(0, 2),
            "hip.retraction_rate": draw(-0.5, 0.5),
            "leg.thrust": draw(0, 0.2),
            "ground.static_friction_ratio": draw(1, 2),
            "ground.stribeck_velocity": rng.choice([0.0, draw(0.1, 2)]),
            "ground.friction": draw(0.05, 0.9),
            "ground.slope": draw(-0.4, 0.4),
            "hip.external_torque": draw(-0.1, 0.1),
            "leg.extension": draw(-0.1, 0.1),
            "body.external_fx": draw(-0.1, 0.1),
            "body.external_fy": draw(-0.1, 0.1),
            "control.touchdown_angle": draw(-0.2, 0.2),
            "control.stance_torque": draw(-0.1, 0.1),
            "control.thrust": draw(0, 0.1),
            "hip.swing_clamp": bool(rng.random() < 0.5),
        }
        self.runner = Runner(self.given)
        values = {name: self.runner[name] for name in exact_names(self.runner)}
        self.balls = Parameters(exact_values(values, {})).balls()
        self.contact = contact or rng.choice(["flight", "stick", "slip", "graze"])
        self.sign = sign or int(rng.choice([-1, 1]))
        off = self.contact in ("flight", "graze")
        self.mode = Mode(
            contact=self.contact,
            sign=self.sign if self.contact == "slip" else 0,
            places=(places := bool(off and rng.random() < 0.5)),
            rises=off and not places,
            drives=bool(rng.random() < 0.5),
            thrusts=bool(rng.random() < 0.5),
        )
        self.values = {
            "length": draw(0.5, 1.4),
            "angle": draw(-1, 1),
            "length_rate": draw(-1, 1),
            "angle_rate": draw(-1, 1),
            "foot_speed": self.sign * draw(0.01, 1),
            "latched_angle": draw(-1, 1),
            "clock": draw(0, 2),
            "height": draw(0.8, 2),
            "along": draw(-1, 1),
            "off": draw(-1, 1),
        }
        whole = with_helpers(self.balls, self.mode, {n: arb(v) for n, v in self.values.items()})
        if off and not self.mode.places and self.given["hip.swing_clamp"]:
            clamped = laws.servo_torque(self.balls, self.mode, Record(**whole)) < 0
            self.mode = Mode(**{**vars(self.mode), "clamped": bool(clamped)})
        self.at = Record(**whole)
        self._fill()

    def _fill(self):
        v, slope = self.values, self.given["ground.slope"]
        tangent, normal = (math.cos(slope), math.sin(slope)), (-math.sin(slope), math.cos(slope))
        if self.contact == "flight":
            foot = laws.foot_velocity(self.balls, self.at)
            height, along, off = (
                float(x) for x in (laws.foot_height(self.balls, self.at), foot.along, foot.off)
            )
        else:
            height, along, off = 0.0, 0.0 if self.contact == "stick" else v["foot_speed"], 0.0
        self.motion = ffi.new("tdmf_motion *")
        state = {
            "foot.x": height * normal[0],
            "foot.y": height * normal[1],
            "leg.length": v["length"],
            "leg.angle": v["angle"],
            "foot.vx": along * tangent[0] + off * normal[0],
            "foot.vy": along * tangent[1] + off * normal[1],
            "leg.length_rate": v["length_rate"],
            "leg.angle_rate": v["angle_rate"],
        }
        self.motion.state[0 : len(STATES)] = [state[name] for name in STATES]
        self.motion.state[c.TDMF_HIP_PLACE_TIME] = v["clock"]
        mode = self.motion.mode
        mode.contact = CONTACTS[self.sign if self.contact == "slip" else self.contact]
        if self.contact in ("flight", "graze"):
            mode.phase = c.TDMF_PHASE_PLACE if self.mode.places else c.TDMF_PHASE_RETRACT
        else:
            mode.phase = c.TDMF_PHASE_DRIVE if self.mode.drives else c.TDMF_PHASE_COAST
        mode.liftoff_angle, mode.mid_stance_pending = v["latched_angle"], self.mode.drives
        mode.clamp_closed, mode.thrusts = self.mode.clamped, self.mode.thrusts
        mode.rises = not self.mode.places
        mode.ground = c.tdmf_ground_line_of(0.0, slope)
        self.tangent, self.normal = tangent, normal

    def numbers(self):
        return {name: arb(self.values[name]) for name in names_of(self.balls, self.mode)}


def exact_names(runner):
    from tdmf_slip.library.members import MOVING

    return [name for name in MOVING if name in runner]


def close(one, other, scale=1.0):
    return abs(float(one) - float(other)) <= 2e-13 * max(scale, abs(float(other)))


def test_rates_are_those_of_the_library():
    rng = np.random.default_rng(27)
    seen, falls = set(), 0
    for _ in range(POINTS):
        point = Point(rng)
        if point.contact == "graze" and abs(float(point.at.sine)) < 0.05:
            continue
        derivatives = ffi.new("double[]", c.TDMF_STATE_COUNT)
        c.tdmf_derivatives(
            point.runner.c_system,
            ffi.addressof(point.motion.mode),
            point.motion.state,
            derivatives,
        )
        found = laws.rates(point.balls, point.mode, point.at)
        size = max(abs(x) for x in derivatives)
        assert close(found["length_rate"], derivatives[c.TDMF_LEG_LENGTH_RATE], size)
        assert close(found["angle_rate"], derivatives[c.TDMF_LEG_ANGLE_RATE], size)
        x, y = derivatives[c.TDMF_FOOT_VX], derivatives[c.TDMF_FOOT_VY]
        if point.contact in ("slip", "graze"):
            assert close(found["foot_speed"], x * point.tangent[0] + y * point.tangent[1], size)
        torque = c.tdmf_hip_torque(
            point.runner.c_system, ffi.addressof(point.motion.mode), point.motion.state
        )
        assert close(laws.torque(point.balls, point.mode, point.at), torque, size)
        seen.add((point.contact, point.mode.places, point.mode.drives, point.mode.clamped))
        falls += point.contact == "slip" and point.given["ground.stribeck_velocity"] > 0
    assert len(seen) >= 16
    assert falls > 50


def test_the_centre_of_mass_falls_as_in_the_library():
    rng = np.random.default_rng(5)
    for _ in range(100):
        point = Point(rng, "flight")
        derivatives = ffi.new("double[]", c.TDMF_STATE_COUNT)
        c.tdmf_derivatives(
            point.runner.c_system,
            ffi.addressof(point.motion.mode),
            point.motion.state,
            derivatives,
        )
        given = point.given
        total = given["body.mass"] + given["foot.mass"]
        x, y = given["body.external_fx"] / total, given["body.external_fy"] / total - given["gravity"]
        along, off = fall(point.balls)
        assert close(along, x * point.tangent[0] + y * point.tangent[1])
        assert close(off, x * point.normal[0] + y * point.normal[1])


def test_guards_are_those_of_the_library():
    rng = np.random.default_rng(11)
    compared = dict.fromkeys(GUARDS, 0)
    for _ in range(2 * POINTS):  # the clamp is watched at one point in sixteen
        point = Point(rng)
        guards = ffi.new("double[]", c.TDMF_GUARD_COUNT)
        model = point.runner.c_model
        c.tdmf_guards(point.runner.c_system, ffi.addressof(point.motion.mode), point.motion.state, guards)
        for name in watched(point.balls, point.mode):
            if (name, point.contact) == ("clamp", "graze"):
                continue  # there the library goes by the servo as it is now
            index, scale = GUARDS[name]
            value = float(FUNCTIONS[name](point.balls, point.mode, point.at))
            value /= getattr(model.scales, scale) if scale else 1.0
            margin = 2e-12  # of the library's guards
            assert abs(guards[index] - value) < 1e-12 * abs(value) + margin, (name, point.mode)
            compared[name] += 1
    assert min(compared.values()) > 100, compared


def test_impacts_are_those_of_the_library():
    rng = np.random.default_rng(3)
    sticks = slides = 0
    for _ in range(POINTS):
        point = Point(rng, "flight")
        point.values["height"] = float(point.balls.model.body_share * point.at.length * point.at.cosine)
        point.at.height = arb(point.values["height"])
        point._fill()
        if float(laws.foot_velocity(point.balls, point.at).off) >= 0:
            continue
        before = np.array(list(point.motion.state))
        c.tdmf_impact(
            point.runner.c_system,
            ffi.addressof(point.motion.mode.ground),
            point.motion.state,
        )
        state = point.motion.state
        speed = state[c.TDMF_FOOT_VX] * point.tangent[0] + state[c.TDMF_FOOT_VY] * point.tangent[1]
        transition = Transition(point.balls, point.mode, point.numbers())
        transition.impact()
        assert close(transition.speed, speed)
        assert close(transition.at.length_rate, state[c.TDMF_LEG_LENGTH_RATE])
        assert close(transition.at.angle_rate, state[c.TDMF_LEG_ANGLE_RATE])
        assert not np.array_equal(before, list(state))
        sticks, slides = sticks + (abs(speed) < 1e-14), slides + (abs(speed) >= 1e-14)
    assert sticks > 50
    assert slides > 50
