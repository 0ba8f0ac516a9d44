"""The runner's page, run by the plain driver: reference gaits, Jacobians, and random runs."""

import json
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from conftest import reference_gaits, some_of
from native_runs import STATES, NativeRun, lasting
from page_runs import COMPILER, CompiledPage

from c_core.pages.runner import PlainRunner

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
FREE = json.loads((Path(__file__).parent / "free_swing.json").read_text(encoding="utf-8"))
SECTION = [
    "apex_com_height",
    "apex_com_speed",
    "apex_length",
    "apex_angle",
    "apex_length_rate",
    "apex_angle_rate",
]
FREE_GAITS = [*reference_gaits(False), *FREE["gaits"]]
GAITS = [("free", gait) for gait in FREE_GAITS]
GAITS += [("clamped", gait) for gait in reference_gaits(True)]
GAIT = next(gait for gait in reference_gaits(False) if gait["friction"] == 0.6)
EVERY_GAIT = pytest.mark.parametrize(
    ("reading", "gait"), GAITS, ids=[f"{r} {g['friction']}" for r, g in GAITS]
)


@pytest.fixture(scope="module")
def runner():
    return CompiledPage(PlainRunner)


def world_of(apex, share=1 / 1.1):
    """The world's states at an apex, where the centre of mass is at x = 0."""
    height, speed, length, angle, length_rate, angle_rate = apex
    sine, cosine = np.sin(angle), np.cos(angle)
    body_vx = -length_rate * sine - length * angle_rate * cosine
    body_vy = length_rate * cosine - length * angle_rate * sine
    return {
        "seen_x": share * length * sine,
        "seen_y": height - share * length * cosine,
        "seen_vx": speed - share * body_vx,
        "seen_vy": -share * body_vy,
        "length": length,
        "angle": angle,
        "length_rate": length_rate,
        "angle_rate": angle_rate,
    }


def section(run):
    """The six coordinates of the last apex."""
    return np.array([getattr(run, name) for name in SECTION])


def word(run):
    """The gait word of the last stride."""
    code = int(run.word_code)
    letters = (np.base_repr(abs(code), 4) if code else "").translate(str.maketrans("0123", "|-0+"))
    return letters + "~" * (code < 0)


def jacobian(page, apex, **given):
    """The return map's derivative by the six coordinates of the section."""
    columns = [world_of(np.array(apex) + 1e-30j * np.eye(6)[i]) for i in range(6)]
    run = page.start(seeds=list(world_of(apex)), **given, **world_of(apex))
    for i, column in enumerate(columns):
        run.dx[i] = 0
        for name, value in column.items():
            run.dx[i, page.states.index(name)] = np.imag(value) / 1e-30
    run.run.seed_count = 6
    run.to(stop="apex")
    return np.array([run.dx[:6, page.states.index(name)] for name in SECTION])


@EVERY_GAIT
def test_gaits_are_those_of_the_references(runner, reading, gait):
    given = {"friction": gait["friction"], "swing_clamp": reading == "clamped", "tolerance": 1e-13}
    given |= {"notes_compression": False}
    run = runner.start(**given, **world_of(gait["apex"]))
    energy = run.to(0.0).outputs["energy"]
    run.to(stop="apex")
    assert word(run) == gait["word"]
    assert section(run) == pytest.approx(gait["apex"], abs=1e-11)
    found = {
        "period": run.period,
        "length": run.distance,
        "work": run.work_of_stride,
        "cost_of_transport": run.cost_of_transport,
        "positive_work": run.positive_work,
        "slip_distance": run.slip_distance,
        "stance_time": run.stance_time,
    }
    assert found == pytest.approx({**found, **{n: gait[n] for n in found if n in gait}}, abs=1e-11)
    lost = run.damper_loss + run.friction_loss + run.impact_loss
    assert run.outputs["energy"] - energy == pytest.approx(run.work - lost, abs=1e-13)
    expected = [time for _, time in gait["events"]]
    if reading == "clamped":
        expected = sorted([*expected, gait["clamp_release"]])
    assert [time for time, *_ in run.log[1:]] == pytest.approx(expected, abs=2e-11)


@pytest.mark.parametrize("gait", FREE_GAITS, ids=[g["friction"] for g in FREE_GAITS])
def test_jacobians_are_those_of_the_references(runner, gait):
    found = jacobian(runner, gait["apex"], tolerance=1e-13, friction=gait["friction"], swing_clamp=False)
    assert found == pytest.approx(np.array(gait["jacobian"]), abs=1e-9)


@pytest.mark.parametrize(
    "seed", ["friction", "damping", "foot_mass", "drive_torque", "kp", "liftoff_factor", "gravity"]
)
def test_derivatives_by_parameters_are_those_of_differences(runner, seed):
    gait, ends, step = GAIT, [], 1e-5
    base, start = dict(runner_defaults(runner), friction=0.6), world_of(gait["apex"])
    start["seen_vy"] -= 0.02  # no apex, whatever the masses
    for value in (base[seed] * (1 + step), base[seed] * (1 - step)):
        run = runner.start(tolerance=1e-14, **{**base, seed: value}, **start).to(stop="apex")
        ends.append(section(run))
    run = runner.start(seeds=[seed], tolerance=1e-14, **base, **start).to(stop="apex")
    exact = np.array([run.d(name)[0] for name in SECTION])
    assert exact == pytest.approx(
        (ends[0] - ends[1]) / (2 * step * base[seed]), abs=1e-7 * (1 + np.abs(exact).max())
    )


def runner_defaults(page):
    return {n: q.value for n, q in page.model.quantities("parameter").items()}


def test_outputs_of_c_are_those_of_the_page_on_plain_numbers(runner):
    run = runner.start(friction=0.6, **world_of(GAIT["apex"]))
    for time in (0.0, 5.0, 12.2, 12.6, 12.85, 13.0, 13.15, 20.0):
        at, outputs = run.to(time).page(), run.outputs
        assert outputs == pytest.approx({name: float(getattr(at, name)()) for name in outputs}, abs=1e-13)


@pytest.mark.parametrize("stride", FREE["strides"], ids=range(len(FREE["strides"])))
def test_strides_of_random_runners_are_those_of_the_references(runner, stride):
    given = runner.names(stride["given"])
    share = given.get("body_mass", 1) / (given.get("body_mass", 1) + given.get("foot_mass", 0.1))
    run = runner.start(tolerance=1e-13, **given, **world_of(stride["apex"], share)).to(stop="apex")
    assert word(run) == stride["word"]
    found = [*section(run), run.period, run.distance, run.work_of_stride, run.touchdowns]
    assert found == pytest.approx(
        [*stride["end"], *(stride[n] for n in ("period", "length", "work", "touchdowns"))], abs=1e-9
    )


def test_a_runner_in_other_units_moves_alike(runner):
    mass, stiffness, length = 80.0, 20000.0, 0.9
    force, rate = stiffness * length, np.sqrt(stiffness / mass)
    height, speed, r, angle, r_rate, turn = GAIT["apex"]
    run = runner.start(
        body_mass=mass,
        foot_mass=0.1 * mass,
        stiffness=stiffness,
        free_length=length,
        least_length=0.05 * length,
        damping=0.2 * np.sqrt(stiffness * mass),
        gravity=0.01 * force / mass,
        drive_torque=0.2 * force * length,
        kp=0.1 * force * length,
        kd=0.1 * force * length / rate,
        friction=0.6,
        tolerance=1e-13,
        **world_of(
            (height * length, speed * length * rate, r * length, angle, r_rate * length * rate, turn * rate)
        ),
    )
    run.to(stop="apex")
    assert section(run) / [length, length * rate, length, 1, length * rate, rate] == pytest.approx(
        GAIT["apex"], abs=1e-11
    )


# ---- random runs beside the native solver --------------------------------------------------------


def drawn(number):
    """A random runner on level ground and its start: near Table 1, and for a third of them far from it."""
    random = np.random.default_rng([46, number])
    u, spread = random.uniform, 3.0 if number % 3 == 0 else 1.3
    times = lambda value: value * spread ** u(-1, 1)  # noqa: E731
    parameters = {
        "body.mass": times(1),
        "foot.mass": times(0.1),
        "leg.stiffness": times(1),
        "leg.damping": times(0.2),
        "leg.free_length": times(1),
        "gravity": times(0.01),
        "hip.stance_torque": times(0.2) * (1 if u() < 0.9 else -1),
        "hip.touchdown_angle": u(0.3, 1.1),
        "hip.kp": times(0.1),
        "hip.kd": times(0.1),
        "hip.liftoff_angle_factor": u(0.8, 1.5),
    }
    inputs = {
        "ground.friction": 10 ** u(-1.5, 1),
        "hip.external_torque": 0.0 if u() < 0.7 else u(-0.005, 0.005),
    }
    parameters["leg.min_length"] = 0.05 * parameters["leg.free_length"]
    length, rate = (
        parameters["leg.free_length"],
        np.sqrt(parameters["leg.stiffness"] / parameters["body.mass"]),
    )
    share = parameters["body.mass"] / (parameters["body.mass"] + parameters["foot.mass"])
    apex = [
        u(1.05, 2.0) * length,
        u(-0.3, 1.5) * length * rate,
        u(0.9, 1.1) * length,
        u(-0.9, 1.4),
        u(-0.05, 0.05) * length * rate,
        u(-0.3, 0.3) * rate,
    ]
    world = world_of(apex, share)
    kind = u()
    if kind < 0.3:  # it starts in contact, or at the instant of an impact
        world |= {
            "seen_y": 0.0,
            "seen_vy": -0.1 * length * rate * u() if kind < 0.15 else 0.0,
            "seen_vx": u(-0.5, 1.5) * length * rate,
            "angle": u(-0.9, 0.9),
            "length": length * u(0.8, 1.0),
        }
        world["seen_vx"] *= u() < 0.7
    return parameters, inputs, world, rate


def trace_page(page, given, segments, nudge=0.0):
    """World states at the end of each segment, and the run; `nudge` changes the start's leg length."""
    given = given | {"length": given["length"] * (1 + nudge)}
    run, rows, until = page.start(**given).to(0.0), [], 0.0
    for duration, changes in segments:
        run.set(**changes)
        until += duration
        if run.to(until).outcome != "arrived":
            break
        rows.append(run.world())
    return rows, run


def trace_native(native, segments):
    """World states of a native run at the end of each segment, which begins with a call of `change`."""
    rows, until = [], 0.0
    for duration, change in segments:
        change(native)
        until += duration
        if native.to(until).fell or native.outcome:
            break
        rows.append(native.state)
    return rows


def difference(page, mine, theirs, scales):
    """The largest difference of a state, in the runner's units, and its name."""
    off = {
        n: abs(mine[n] - theirs[n]) / scales[page.model.quantities("state")[n].unit] / (1 + abs(theirs[n]))
        for n in STATES
        if n in mine
    }
    name = max(off, key=off.get)
    return off[name], name


STRIDE = {
    "peak_force": "N", "peak_vertical_force": "N", "duty_factor": "1", "slip_distance": "m", "period": "s",
    "positive_work": "J", "stance_time": "s",
}  # fmt: skip
"""Quantities of a stride, and their units."""


def difference_of_strides(run, native, scales, tolerance=1e-8):
    """The first difference between the last strides of a page and of a native run; empty if they agree."""
    stride = native.motion.record.stride
    if (run.count, word(run), run.touchdowns) != (stride.count, native.word, stride.touchdowns):
        return f"{run.count} {word(run)}, {stride.count} {native.word}"
    for name, scale in scales.items():
        mine, theirs = getattr(run, name) / scale, getattr(stride, name) / scale
        if mine != pytest.approx(theirs, rel=tolerance, abs=tolerance / 10):
            return f"{name} {mine}, {theirs}"
    return ""


def first_hop(run, rate):
    """Time of the first hop that is so short that the margin of touchdown determines its length."""
    left = -np.inf
    for time, _, before, after in run.log:
        is_flying = [mode.startswith("flight") for mode in (before, after)]
        if is_flying == [True, False] and 0 < time - left < 2e-3 / rate:
            return time
        left = time if is_flying == [False, True] else left
    return np.inf


def compare(page, number, tolerance=1e-13):
    """How a random run compares: its kind, the largest difference of a state, and what is wrong.

    States agree to 1e-9 of the runner's units, or to a hundred times what 1e-14 in the start makes.
    They agree until a foot that is hardly loaded hops.
    """
    parameters, inputs, world, rate = drawn(number)
    clamps = bool(number % 2)
    given = page.names(parameters | inputs) | world
    given |= {"swing_clamp": clamps, "tolerance": tolerance}
    parameters = parameters | {"hip.swing_clamp": clamps}
    native = NativeRun(parameters, inputs, [world[n] for n in STATES[:8]], tolerance)
    if native.refused:
        return "refused", 0.0, ""
    length = parameters["leg.free_length"]
    force = parameters["leg.stiffness"] * length
    scales = {"m": length, "m/s": length * rate, "rad/s": rate, "J": force * length, "s": 1 / rate, "rad": 1}
    durations = [4 / rate] * 17
    mine, run = trace_page(page, given, [(d, {}) for d in durations])
    theirs = trace_native(native, [(d, lambda native: None) for d in durations])
    worst = [difference(page, *pair, scales) for pair in zip(mine, theirs, strict=False)]
    worst.append((abs(run.time - native.motion.time) * rate, "time"))
    fell_alone = (run.outcome == "ended") != native.fell
    if len(mine) != len(theirs) or fell_alone or max(worst)[0] > 1e-9:
        nudged, other = trace_page(page, given, [(d, {}) for d in durations], 1e-14)
        allowed = [difference(page, *pair, scales)[0] for pair in zip(mine, nudged, strict=False)]
        most, hop = 1e-9 + 100 * max(*allowed, abs(run.time - other.time) * rate), first_hop(run, rate)
        if hop < np.inf:  # they agree until then
            before = worst[: int(hop / durations[0])]
            return (
                ("hop" if max(before, default=(0,))[0] < most else "differs"),
                0.0,
                f"{before}, hop at {hop}",
            )
        if len(mine) != len(theirs) or fell_alone or max(worst)[0] > most:
            return "differs", max(worst)[0], f"{max(worst)}: {run.log[-4:]}, {native.modes[-4:]}"
        return "sensitive", 0.0, ""
    mine, theirs = lasting(run.modes_entered(), 1 / rate), lasting(native.modes, 1 / rate)
    if [m[1:] for m in mine] != [m[1:] for m in theirs]:
        return "modes", max(worst)[0], f"{mine}, {theirs}"
    if text := difference_of_strides(run, native, dict.fromkeys(STRIDE, 1)):
        return "stride", max(worst)[0], text
    return "same", max(worst)[0], ""


def test_random_runs_are_those_of_the_native_solver(runner):
    """The library starts a run, reads motions into the page and back, and keeps a record of strides."""
    found, faults, worst = Counter(), [], []
    for number in some_of(range(20000), 400):
        kind, off, text = compare(runner, number)
        found[kind] += 1
        worst.append(off)
        if kind not in ("same", "sensitive", "hop", "refused"):
            faults.append(f"{number}: {kind}: {text}")
    assert not faults, "\n".join(faults[:20])
    assert found["same"] > 0.99 * found.total()
    assert np.median(worst) < 1e-12
