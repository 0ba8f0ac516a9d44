"""The laws of proofs, in the leg's length and angle, against the runner's page in the page's coordinates."""

import math
from types import SimpleNamespace as Record

import numpy as np
import pytest

pytest.importorskip("flint")

from flint import arb, ctx
from tdmf_slip.library.members import MOVING
from tdmf_slip.library.runner import Runner
from tdmf_slip.pages import RunnerOnOneLine
from tdmf_slip.proof.flow import rates, with_helpers
from tdmf_slip.proof.given import exact_values
from tdmf_slip.proof.guards import EVENTS, guard_of, watched
from tdmf_slip.proof.parameters import NAMES_ON_PAGE, Mode, Parameters, at
from tdmf_slip.proof.transitions import Transition

POINTS = 60
"""Random points of each mode."""
GIVEN = {
    "body.mass": (0.5, 2), "foot.mass": (0.01, 1), "leg.stiffness": (0.5, 2), "leg.damping": (0, 1),
    "gravity": (0.01, 1), "hip.stance_torque": (-0.5, 0.5), "hip.touchdown_angle": (-1, 1),
    "hip.kp": (0.01, 1), "hip.kd": (0.01, 1), "hip.liftoff_angle_factor": (0, 2),
    "hip.retraction_rate": (-0.5, 0.5), "leg.thrust": (0, 0.2), "ground.static_friction_ratio": (1, 2),
    "ground.friction": (0.05, 0.9), "ground.slope": (-0.4, 0.4), "hip.external_torque": (-0.1, 0.1),
    "leg.extension": (-0.1, 0.1), "body.external_fx": (-0.1, 0.1), "body.external_fy": (-0.1, 0.1),
    "control.touchdown_angle": (-0.2, 0.2), "control.stance_torque": (-0.1, 0.1), "control.thrust": (0, 0.1),
}  # fmt: skip
MOTION = {
    "length": (0.5, 1.4), "angle": (-1, 1), "length_rate": (-1, 1), "angle_rate": (-1, 1),
    "liftoff_angle": (-1, 1), "placing": (0, 2), "clearance": (0.8, 2), "along": (-1, 1), "off": (-1, 1),
}  # fmt: skip


def point(rng, contact):
    """A random runner in a mode: as proofs have it, and on the page in floats."""
    given = {name: rng.uniform(*ends) for name, ends in GIVEN.items()}
    given |= {"ground.stribeck_velocity": rng.choice([0.0, 0.7]), "hip.swing_clamp": True}
    runner = Runner(given)
    balls = Parameters(exact_values({name: runner[name] for name in MOVING}, {})).balls()
    v = {name: rng.uniform(*ends) for name, ends in MOTION.items()}
    off, sign = contact in ("flight", "graze"), int(rng.choice([-1, 1]))
    v["foot_vx"] = sign * rng.uniform(0.01, 1) if contact in ("slip", "graze") else 0.0
    places = bool(off and rng.random() < 0.5)
    mode = Mode(
        contact, sign if contact == "slip" else 0, places, drives=not off and bool(rng.random() < 0.5),
        clamped=off and not places and bool(rng.random() < 0.5), rises=off and not places,
        thrusts=not off and bool(rng.random() < 0.5),
    )  # fmt: skip
    values = with_helpers(balls, mode, {name: arb(x) for name, x in v.items()})
    slope = given["ground.slope"]
    sine, cosine, turn = (
        math.sin(v["angle"] - slope),
        math.cos(v["angle"] - slope),
        v["length"] * v["angle_rate"],
    )
    ground = {
        "x": -v["length"] * sine, "y": v["length"] * cosine, "vx": -v["length_rate"] * sine - turn * cosine,
        "vy": v["length_rate"] * cosine - turn * sine, "winding": slope, "foot_vx": v["foot_vx"],
    }  # fmt: skip
    flight = {
        "length": v["length"], "angle": v["angle"], "length_rate": v["length_rate"],
        "momentum": v["length"] * turn, "com_y": v["clearance"] / math.cos(slope),
        "com_vx": v["along"] * math.cos(slope) - v["off"] * math.sin(slope),
        "com_vy": v["along"] * math.sin(slope) + v["off"] * math.cos(slope),
    }  # fmt: skip
    motion = at(balls, mode, values)
    held = {name: getattr(motion, name) for name in ("swing", "driving", "thrusting", "way", "law")}
    held |= {name: v[name] for name in ("liftoff_angle", "placing")} | {"slope": slope, "wind": "pushed"}
    own = {of: runner[name] for name, of in NAMES_ON_PAGE.items() if name in MOVING}
    page = RunnerOnOneLine.at(contact, **own, **held, **(flight if contact == "flight" else ground))
    return Record(balls=balls, mode=mode, values=values, motion=motion, page=page, sine=sine, cosine=cosine)


def close(one, other):
    return abs(float(one) - float(other)) <= 1e-12 * max(1.0, abs(float(other)))


@pytest.fixture(params=["flight", "stick", "slip", "graze"])
def points(request):
    rng = np.random.default_rng(27)
    with ctx.workprec(113):
        yield [p for p in (point(rng, request.param) for _ in range(POINTS)) if abs(p.sine) > 0.05]


def test_rates_are_those_of_the_page(points):
    for p in points:
        found, page = rates(p.balls, p.mode, p.values), p.page
        wanted = getattr(page, p.mode.contact)()
        r, w, v = (float(p.values[name]) for name in ("length", "angle_rate", "length_rate"))
        along, across = float(found["length_rate"]) - r * w * w, r * float(found["angle_rate"]) + 2 * v * w
        if p.mode.contact == "flight":
            fall = page.on_line(wanted["com_vx"], wanted["com_vy"])
            assert close(found["length_rate"], wanted["length_rate"])
            assert close(across * r, wanted["momentum"])
            assert close(p.balls.fall().along, fall.along) and close(p.balls.fall().off, fall.off)
        else:
            assert close(-along * p.sine - across * p.cosine, wanted["vx"])
            assert close(along * p.cosine - across * p.sine, wanted["vy"])
            assert close(found.get("foot_vx", 0), wanted["foot_vx"])
        assert close(p.motion.torque(), page.torque())


def test_guards_are_those_of_the_page(points):
    seen = set()
    for p in points:
        for name in watched(p.motion):
            event = "release" if name == "clamp" and p.mode.clamped else EVENTS[name]
            assert close(guard_of(name, p.motion), p.page.marked("is_event")[event].when(p.page)), name
            seen.add(name)
    assert len(seen) >= 5


@pytest.mark.parametrize("points", ["flight"], indirect=True)
def test_impacts_are_those_of_the_page(points):
    slides = 0
    for p in points:
        foot = p.motion.foot()
        if not foot.off < 0:
            continue
        transition, landed = Transition(p.balls, p.mode, p.values), p.page.land(was_placed=0)
        slides += transition.impact()
        after = transition.values
        assert close(after["foot_vx"], landed.foot_vx)
        assert close(after["length_rate"], landed.leg().length_rate)
        assert close(after["angle_rate"], landed.leg().angle_rate)
    assert 5 < slides < len(points) - 5
