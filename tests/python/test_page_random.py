"""Random runs of the whole page beside the native solver: everything on, ramps and jumps in mid-stance."""

from collections import Counter

import numpy as np
import pytest
from conftest import some_of
from native_runs import STATES, VARIABLES, NativeRun, clipped, lasting
from page_runs import COMPILER, CompiledPage
from test_page_runner import (
    STRIDE,
    difference,
    difference_of_strides,
    first_hop,
    trace_native,
    trace_page,
    world_of,
)
from test_page_whole import whole  # noqa: F401

from c_core.hybrid.limits import MARGINS
from c_core.pages.runner import Runner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
RAMPED = {
    "ground.friction": 2e-3, "leg.extension": 2e-3, "hip.external_torque": 2e-4, "body.external_fx": 1e-4,
    "body.external_fy": 1e-4,
}  # fmt: skip
"""Inputs that are ramped, and how fast at most, in units m = k = l0 = 1."""
INPUTS = (*RAMPED, "ground.height", "ground.slope", "control.touchdown_angle", "control.stance_torque",
          "control.thrust")  # fmt: skip
NEAR = {
    "leg.damping": (0.15, 0.26), "gravity": (0.0077, 0.013), "hip.liftoff_angle_factor": (0.8, 1.5),
    "leg.min_length": (0.05, 0.05), "ground.static_friction_ratio": (1, 1.6),
    "ground.stribeck_velocity": (0.01, 0.5), "ground.patch_begin": (5, 16),
    "ground.patch_friction": (0.05, 1.2),
    "ground.friction": (0.03, 1.5), "leg.extension": (-0.03, 0.03), "hip.external_torque": (-5e-3, 5e-3),
    "body.external_fx": (-1e-3, 1e-3), "body.external_fy": (-2e-3, 2e-3), "ground.height": (-0.05, 0.05),
    "ground.slope": (-0.06, 0.06), "control.touchdown_angle": (-0.1, 0.1),
    "control.stance_torque": (-0.05, 0.05), "control.thrust": (0, 0.02), "leg.thrust": (0, 0.05),
    "hip.stance_torque": (0.1, 0.3), "hip.retraction_rate": (-0.004, 0.012),
    "hip.touchdown_angle": (0.5, 0.9), "hip.kp": (0.03, 0.3), "hip.kd": (0.03, 0.3),
}  # fmt: skip
"""Ranges of a runner near Table 1, in units m = k = l0 = 1."""
FAR = {
    "leg.damping": (1e-4, 1e3), "gravity": (1e-7, 10), "hip.liftoff_angle_factor": (0.01, 100),
    "leg.min_length": (1e-3, 0.9), "ground.static_friction_ratio": (1, 1e6),
    "ground.stribeck_velocity": (1e-6, 1e4), "ground.patch_begin": (1e-3, 1e6),
    "ground.patch_friction": (1e-4, 1e6),
    "ground.friction": (1e-4, 1e6), "leg.extension": (1e-4, 0.5), "hip.external_torque": (1e-6, 1),
    "body.external_fx": (1e-7, 1), "body.external_fy": (1e-7, 1), "ground.height": (1e-3, 10),
    "ground.slope": (1e-3, 0.99), "control.touchdown_angle": (1e-3, np.pi),
    "control.stance_torque": (1e-4, 10),
    "control.thrust": (1e-4, 1), "leg.thrust": (1e-4, 1), "hip.stance_torque": (1e-4, 10),
    "hip.retraction_rate": (1e-5, 10), "hip.touchdown_angle": (1e-2, np.pi / 2), "hip.kp": (1e-4, 1e3),
    "hip.kd": (1e-4, 1e3),
}  # fmt: skip
"""Sizes that a runner far from Table 1 may have: the allowed ranges, as far as a solver can follow runs."""
SIGNED = {n for n, (low, _) in NEAR.items() if low < 0} | {
    "hip.stance_torque", "hip.touchdown_angle", "ground.patch_begin", "control.thrust",
}  # fmt: skip
STEP_LIMIT = 20000
AT_JUMPS = "peak_vertical_force"
"""Where an input jumps, the core also counts this force in a mode that ends at once."""


def drawn(number):
    """A random runner, its start, and the segments of its run.

    Inputs and tunable parameters may be set where a segment begins, and inputs are ramped within it.

    In a third of the runners, some or all parameters are drawn over their whole range, and the masses,
    the stiffness and the length over many powers of ten.
    """
    random = np.random.default_rng([48, number])
    u, is_far = random.uniform, number % 3 == 0
    share_far = random.choice([0.05, 0.15, 0.5]) if is_far else 0.0
    mass, stiffness, length = (10 ** u(-most, most) if is_far else 1.3 ** u(-1, 1) for most in (8, 8, 5))
    foot_mass = mass * (10 ** u(-4, 1) if u() < share_far else u(0.03, 0.3))
    rate, force = np.sqrt(stiffness / mass), stiffness * length
    torque = force * length
    units = {
        "leg.damping": np.sqrt(stiffness * mass), "gravity": force / mass, "leg.extension": length,
        "hip.external_torque": torque, "body.external_fx": force, "body.external_fy": force,
        "ground.height": length, "control.stance_torque": torque, "control.thrust": length,
        "leg.thrust": length,
        "hip.stance_torque": torque, "hip.retraction_rate": rate, "hip.kp": torque, "hip.kd": torque / rate,
        "leg.min_length": length, "ground.stribeck_velocity": length * rate, "ground.patch_begin": length,
    }  # fmt: skip

    def draw(name):
        value = u(*NEAR[name])
        if u() < share_far:
            low, high = np.log10(FAR[name])
            value = 0.0 if u() < 0.1 else 10 ** u(low, high)
            value *= random.choice([-1, 1]) if name in SIGNED else 1
        return clipped(name, value * units.get(name, 1))

    parameters = {n: draw(n) for n in NEAR if n not in INPUTS}
    parameters |= {"ground.static_friction_ratio": 1.0} if u() < 0.3 else {}
    parameters |= {"ground.stribeck_velocity": 0.0} if u() < 0.4 else {}
    patch = (0 if u() < 0.3 else 10 ** u(-2, 1)) * length
    parameters |= {
        "body.mass": mass, "foot.mass": foot_mass, "leg.stiffness": stiffness, "leg.free_length": length,
        "ground.patch_end": parameters["ground.patch_begin"] + patch,
    }  # fmt: skip
    inputs = {n: draw(n) if n == "ground.friction" or u() < 0.6 else 0.0 for n in INPUTS}
    apex = [u(1.2, 2.0) * length, u(0.2, 1.5) * length * rate, u(0.9, 1.1) * length, u(-0.8, 1.4),
            u(-0.05, 0.05) * length * rate, u(-0.3, 0.3) * rate]  # fmt: skip
    segments = []
    changing = sorted(n for n in NEAR if n in INPUTS or VARIABLES[n].get("variability") == "tunable")
    for duration in [u(6, 14), *u(0.02, 0.5, 6), u(5, 15), *u(0.02, 0.5, 4), u(5, 15)]:
        sets = {}
        if u() < 0.4:
            names = random.choice(changing, size=3, replace=False)
            sets = {str(name): draw(name) for name in names}
        faster = 10 ** u(0, 3) if u() < share_far else 1
        rates = {n: u(-1, 1) * most * faster * units.get(n, 1) * rate if u() < 0.5 else 0.0
                 for n, most in RAMPED.items()}  # fmt: skip
        segments.append((duration / rate, sets, rates))
    world = world_of(apex, mass / (mass + foot_mass))
    world["seen_vy"] += 0.0 if u() < 0.3 else u(-0.1, 0.1) * length * rate  # else it starts at an apex
    world["seen_y"] += inputs["ground.height"] + abs(np.tan(inputs["ground.slope"])) * 3 * length
    return parameters, inputs, world, segments, (length, rate, force)


def same_inputs(native):
    """Change nothing."""


def compare(page, number, tolerance=1e-13):
    """How a random run compares: see test_page_runner.compare."""
    parameters, inputs, world, segments, (length, rate, force) = drawn(number)
    clamps = bool(number % 2)
    given = page.names(parameters | inputs) | world
    given |= {"swing_clamp": clamps, "tolerance": tolerance, "step_limit": STEP_LIMIT}
    state = [world[n] for n in STATES[:8]]
    setup = parameters | {"hip.swing_clamp": clamps}, inputs, state, tolerance, STEP_LIMIT
    native = NativeRun(*setup)
    if native.refused:
        return "refused", 0.0, native.refused
    mine_segments, native_segments = [], []
    for duration, sets, rates in segments:
        ramps = {f"{n}_rate": v for n, v in page.names(rates).items()}
        mine_segments.append((duration, page.names(sets) | ramps))

        def change(native, sets=sets, rates=rates):
            native.set(
                {n: v for n, v in sets.items() if n not in INPUTS},
                {n: v for n, v in sets.items() if n in INPUTS},
                rates,
            )

        native_segments.append((duration, change))
    scales = {"m": length, "m/s": length * rate, "rad/s": rate, "J": force * length, "s": 1 / rate, "rad": 1,
              "N": force, "1": 1}  # fmt: skip
    mine, run = trace_page(page, given, mine_segments)
    theirs = trace_native(native, native_segments)
    worst = [difference(page, *pair, scales) for pair in zip(mine, theirs, strict=False)]
    fell_alone = (run.outcome == "ended") != native.fell
    noted_until = min(native.noted_until, run.noted_until) - 1e-6 / rate
    entered = [lasting(modes, 1 / rate, noted_until) for modes in (run.modes_entered(), native.modes)]
    same = [[row[1:] for row in rows] for rows in entered]
    is_same = len(mine) == len(theirs) and not fell_alone and same[0] == same[1]
    if is_same and max(worst, default=(0,))[0] < 1e-9:
        text = difference_of_strides(
            run, native, {n: scales[u] for n, u in STRIDE.items() if n != AT_JUMPS}, 1e-6
        )
        return ("stride" if text else "same"), max(worst, default=(0,))[0], text
    ends = np.cumsum([duration for duration, *_ in segments])
    flung = [end for row, end in zip(mine, ends, strict=False) if row["length"] > 100 * length]
    until = min(first_hop(run, rate), *flung, np.inf)
    before = [off for (off, _), end in zip(worst, ends, strict=False) if end < until]
    if until < np.inf and max(before, default=0) < 1e-9:
        return "hop", 0.0, ""
    nudged, _ = trace_page(page, given, mine_segments, 1e-13)
    allowed = [1e-9 + 100 * difference(page, *pair, scales)[0] for pair in zip(mine, nudged, strict=False)]
    is_close = all(off < may for (off, _), may in zip(worst, allowed, strict=False))
    if is_close and (is_same or max(allowed, default=0) > 1e-6):  # chaotic runs take other events
        return "sensitive", 0.0, ""
    parts = 20  # the core's steps may be too long for falling friction
    shorter = [
        (d / parts, change if i == 0 else same_inputs) for d, change in native_segments for i in range(parts)
    ]
    rows = trace_native(NativeRun(*setup), shorter)[parts - 1 :: parts]
    off = [difference(page, *pair, scales)[0] for pair in zip(mine, rows, strict=False)]
    if len(rows) == len(mine) and max(off, default=0) < 1e-9:
        return "coarse core", 0.0, ""
    is_stiff = run.outcome == "too-many-steps" or native.outcome in (2, 3, 5)
    if is_stiff and max(worst, default=(0,))[0] < 1e-9:
        return "stiff", 0.0, ""
    first = next((i for i, (off, _) in enumerate(worst) if off > 1e-9), len(worst))
    parting = next((p for p in zip(*entered, strict=False) if p[0][1:] != p[1][1:]), None)
    return (
        "differs",
        0.0,
        f"{run.outcome} {native.outcome} at {ends[first - 1]}: {worst[first : first + 1]}, {parting}",
    )


def test_random_runs_with_everything_on_are_those_of_the_native_solver(whole):  # noqa: F811
    found, faults = Counter(), []
    for number in some_of(range(20000), 100):
        kind, _, text = compare(whole, number)
        found[kind] += 1
        if kind in ("differs", "stride"):
            faults.append(f"{number}: {text}")
    assert not faults, f"{dict(found)}\n" + "\n".join(faults[:20])
    assert found["same"] > 0.9 * found.total()


def trace_with_margins(page, number, nudge=0.0):
    """World states along a random run of a page, the events, and the scales of its units."""
    parameters, inputs, world, segments, (length, rate, force) = drawn(number)
    given = page.names(parameters | inputs) | world
    given |= {"swing_clamp": bool(number % 2), "tolerance": 1e-13, "step_limit": STEP_LIMIT}
    changes = [
        (duration, page.names(sets) | {f"{n}_rate": v for n, v in page.names(rates).items()})
        for duration, sets, rates in segments
    ]
    rows, run = trace_page(page, given, changes, nudge)
    scales = {"m": length, "m/s": length * rate, "rad/s": rate, "J": force * length, "s": 1 / rate, "rad": 1,
              "N": force, "1": 1}  # fmt: skip
    return rows, [name for _, name, *_ in run.log], scales


def test_no_result_depends_on_a_margin(monkeypatch):
    """With all margins times 0.1 or 10, runs differ by a hundred times rounding at most."""
    pages = {}
    for factor in (1.0, 0.1, 10.0):
        for name, margin in MARGINS.items():
            monkeypatch.setitem(MARGINS, name, margin * factor)
        changed = f" -DTDMF_MARGIN_FACTOR={factor}" if factor != 1.0 else ""
        pages[factor] = CompiledPage(Runner, level=f"-O1{changed}")
        monkeypatch.undo()
    faults, sensitive = [], 0
    for number in some_of(range(1000), 12):
        rows, events, scales = trace_with_margins(pages[1.0], number)
        nudged, _, _ = trace_with_margins(pages[1.0], number, 1e-15)
        by_rounding = [difference(pages[1.0], *pair, scales)[0] for pair in zip(rows, nudged, strict=False)]
        if max(by_rounding, default=0) > 1e-10:  # chaotic
            sensitive += 1
            continue
        for factor in (0.1, 10.0):
            others, taken, _ = trace_with_margins(pages[factor], number)
            off = [difference(pages[1.0], *pair, scales)[0] for pair in zip(rows, others, strict=False)]
            allowed = 1e-12 + 100 * max(by_rounding, default=0)
            if taken != events or len(others) != len(rows) or max(off, default=0) > allowed:
                faults.append(f"{number} times {factor}: {max(off, default=0)}, allowed {allowed}")
    assert not faults, "\n".join(faults)
    assert sensitive <= 20


def test_a_step_does_not_jump_over_a_layer_of_falling_friction(whole):  # noqa: F811
    """In this run the core's steps are too long for the layer; in twenty times as many it agrees."""
    assert compare(whole, 14328)[0] == "coarse core"
