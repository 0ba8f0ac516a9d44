"""Random runs of the whole runner's page beside the core: everything on, ramps and jumps in mid-stance."""

from collections import Counter

import numpy as np
import pytest
from conftest import some_of
from old_core import STATES, OldRun, lasting
from page_runs import COMPILER
from test_page_runner import difference, first_hop, trace_core, trace_page, world_of
from test_page_whole import whole  # noqa: F401

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
RAMPED = {
    "ground.friction": 2e-3, "leg.extension": 2e-3, "hip.external_torque": 2e-4, "body.external_fx": 1e-4,
    "body.external_fy": 1e-4,
}  # fmt: skip
"""Inputs that are ramped, and how fast at most, in units m = k = l0 = 1."""
INPUTS = (
    *RAMPED,
    "ground.height",
    "ground.slope",
    "control.touchdown_angle",
    "control.stance_torque",
    "control.thrust",
)


def drawn(number):
    """A runner, its start and segments of time, each of which begins with something set or ramped."""
    random = np.random.default_rng([47, number])
    u, is_far = random.uniform, number % 3 == 0
    times = lambda value: value * (10 if is_far else 1.3) ** u(-1, 1)  # noqa: E731
    mass, stiffness, length = times(1), times(1), times(1)
    foot_mass = mass * (10 ** u(-3, 0.3) if is_far else u(0.03, 0.3))
    rate, force = np.sqrt(stiffness / mass), stiffness * length
    units = {"ground.friction": 1, "leg.extension": length, "hip.external_torque": force * length,
             "body.external_fx": force, "body.external_fy": force, "ground.height": length, "ground.slope": 1,
             "control.touchdown_angle": 1, "control.stance_torque": force * length, "control.thrust": length,
             "leg.thrust": length, "hip.stance_torque": force * length, "hip.retraction_rate": rate,
             "hip.touchdown_angle": 1, "hip.kp": force * length, "hip.kd": force * length / rate}  # fmt: skip
    span = {"ground.friction": (0.03, 1.5), "leg.extension": (-0.03, 0.03),
            "hip.external_torque": (-5e-3, 5e-3),
            "body.external_fx": (-1e-3, 1e-3), "body.external_fy": (-2e-3, 2e-3),
            "ground.height": (-0.05, 0.05),
            "ground.slope": (-0.06, 0.06), "control.touchdown_angle": (-0.1, 0.1),
            "control.stance_torque": (-0.05, 0.05),
            "control.thrust": (0, 0.02), "leg.thrust": (0, 0.05), "hip.stance_torque": (0.1, 0.3),
            "hip.retraction_rate": (-0.004, 0.012), "hip.touchdown_angle": (0.5, 0.9), "hip.kp": (0.03, 0.3),
            "hip.kd": (0.03, 0.3)}  # fmt: skip

    def draw(name):
        return u(*span[name]) * units[name]

    begin = u(5, 16) * length
    patch = (0 if u() < 0.3 else 10 ** u(-2, 1)) * length
    parameters = {
        "body.mass": mass, "foot.mass": foot_mass, "leg.stiffness": stiffness, "leg.free_length": length,
        "leg.damping": np.sqrt(stiffness * mass) * times(0.2), "gravity": 0.01 * force / mass * times(1),
        "leg.min_length": 0.05 * length, "ground.static_friction_ratio": 1.0 if u() < 0.3 else u(1, 1.6),
        "ground.stribeck_velocity": 0.0 if u() < 0.4 else 10 ** u(-2, -0.3) * length * rate,
        "ground.patch_begin": begin, "ground.patch_end": begin + patch,
        "ground.patch_friction": u(0.05, 1.2), "hip.liftoff_angle_factor": u(0.8, 1.5),
    }  # fmt: skip
    parameters |= {n: draw(n) for n in span if n not in INPUTS}
    inputs = {n: draw(n) if n == "ground.friction" or u() < 0.6 else 0.0 for n in INPUTS}
    apex = [u(1.2, 2.0) * length, u(0.2, 1.5) * length * rate, u(0.9, 1.1) * length, u(-0.8, 1.4),
            u(-0.05, 0.05) * length * rate, u(-0.3, 0.3) * rate]  # fmt: skip
    segments = []
    for duration in [u(6, 14), *u(0.02, 0.5, 6), u(5, 15), *u(0.02, 0.5, 4), u(5, 15)]:
        sets = {}
        if u() < 0.4:
            names = random.choice(sorted(span), size=3, replace=False)
            sets = {str(name): draw(name) for name in names}
        rates = {n: u(-1, 1) * most * units[n] * rate if u() < 0.5 else 0.0 for n, most in RAMPED.items()}
        segments.append((duration / rate, sets, rates))
    world = world_of(apex, mass / (mass + foot_mass))
    com_slope = inputs["ground.slope"]
    world["seen_y"] += inputs["ground.height"] + abs(np.tan(com_slope)) * 3 * length
    return parameters, inputs, world, segments, (length, rate, force)


def compare(page, number, tolerance=1e-13):
    """How a random run compares: see test_page_runner.compare."""
    parameters, inputs, world, segments, (length, rate, force) = drawn(number)
    clamps = bool(number % 2)
    names = {page.model.public(n): n for n in [*page.states, *page.parameters]}
    given = {names[n]: v for n, v in (parameters | inputs).items()} | world
    given |= {"swing_clamp": clamps, "tolerance": tolerance}
    old = OldRun(parameters | {"hip.swing_clamp": clamps}, inputs, [world[n] for n in STATES[:8]], tolerance)
    if old.refused:
        return "refused", 0.0, old.refused
    mine_segments, old_segments = [], []
    for duration, sets, rates in segments:
        changes = {names[n]: v for n, v in sets.items()} | {f"{names[n]}_rate": v for n, v in rates.items()}
        mine_segments.append((duration, changes))

        def change(old, sets=sets, rates=rates):
            old.set(
                {n: v for n, v in sets.items() if n not in INPUTS},
                {n: v for n, v in sets.items() if n in INPUTS},
                rates,
            )

        old_segments.append((duration, change))
    scales = {"m": length, "m/s": length * rate, "rad/s": rate, "J": force * length, "s": 1 / rate, "rad": 1}
    mine, run = trace_page(page, given, mine_segments)
    theirs = trace_core(old, old_segments)
    worst = [difference(page, *pair, scales) for pair in zip(mine, theirs, strict=False)]
    fell_alone = (run.outcome == "ended") != old.fell
    entered = lasting(run.modes_entered()), lasting(old.modes)
    same = [[row[1:] for row in rows] for rows in entered]
    if (
        len(mine) == len(theirs)
        and not fell_alone
        and max(worst, default=(0,))[0] < 1e-9
        and same[0] == same[1]
    ):
        return "same", max(worst, default=(0,))[0], ""
    ends = np.cumsum([duration for duration, *_ in segments])
    hop = first_hop(run, rate)
    before = [off for (off, _), end in zip(worst, ends, strict=False) if end < hop]
    if hop < np.inf and max(before, default=0) < 1e-9:
        return "hop", 0.0, ""
    nudged, _ = trace_page(page, given, mine_segments, 1e-14)
    allowed = [1e-9 + 100 * difference(page, *pair, scales)[0] for pair in zip(mine, nudged, strict=False)]
    is_close = all(off < may for (off, _), may in zip(worst, allowed, strict=False))
    if len(mine) == len(theirs) and not fell_alone and same[0] == same[1] and is_close:
        return "sensitive", 0.0, ""
    first = next((i for i, (off, _) in enumerate(worst) if off > 1e-9), len(worst))
    parting = next((p for p in zip(*entered, strict=False) if p[0][1:] != p[1][1:]), None)
    return (
        "differs",
        0.0,
        f"{run.outcome} {old.outcome} at {ends[first - 1]}: {worst[first : first + 1]}, {parting}",
    )


def test_random_runs_with_everything_on_are_those_of_the_core(whole):  # noqa: F811
    found, faults = Counter(), []
    for number in some_of(range(20000), 300):
        kind, _, text = compare(whole, number)
        found[kind] += 1
        if kind == "differs":
            faults.append(f"{number}: {text}")
    assert not faults, f"{dict(found)}\n" + "\n".join(faults[:20])
    assert found["same"] > 0.9 * found.total()
