"""The runner's page beside references, differences and the table of the unit's variables."""

import numpy as np
import pytest
from conftest import some_of, unit_reference
from page_runs import BEHIND, CompiledPage
from references import read
from runner_pages import (
    MECHANICAL,
    SECTION,
    STATES,
    STEP_LIMIT,
    drawn,
    section,
    whole_page,
    world_of,
)

from c_core.hybrid.limits import MARGINS
from c_core.pages.runner import Runner

FRICTION = read("friction_cases.json")
GAIT = unit_reference()


def before_impact(case):
    """The numbers that an impact depends on, by the page's names."""
    return {
        "seen_vx": case["speed_before"], "seen_vy": -case["normal_speed"], "friction": case["friction"],
        "static_ratio": case["static_friction_ratio"], "stribeck_velocity": case["stribeck_velocity"],
    }  # fmt: skip


def impact(page, case, seeds=(), **changes):
    """A run that starts with an impact, at the instant after it."""
    start = before_impact(case) | {"seen_y": 0.0, "length": 0.95, "angle": -0.3}
    return page.start(seeds=seeds, **start | changes).to(0.0)


@pytest.mark.parametrize("case", FRICTION["impacts"], ids=range(len(FRICTION["impacts"])))
def test_impacts_under_falling_friction_are_those_of_the_references(whole, case):
    assert impact(whole, case).foot_vx == pytest.approx(case["speed_after"], abs=1e-14)
    assert impact(whole, case, seen_vx=-case["speed_before"]).foot_vx == pytest.approx(
        -case["speed_after"], abs=1e-14
    )
    border = case["sticks_up_to"]
    assert impact(whole, case, seen_vx=border - 1e-12).foot_vx == 0
    assert impact(whole, case, seen_vx=border + 1e-12).foot_vx > 0
    seeds = list(before_impact(case))
    run = impact(whole, case, seeds)
    for seed, exact in zip(seeds, run.d("foot_vx"), strict=True):
        value = before_impact(case)[seed]
        step = 1e-6 * abs(value)
        ends = [impact(whole, case, **{seed: value + sign * step}).foot_vx for sign in (1, -1)]
        assert exact == pytest.approx((ends[0] - ends[1]) / (2 * step), abs=1e-7 * (1 + abs(exact))), seed


@pytest.mark.parametrize("case", FRICTION["stands"], ids=[c["mode_after_start"] for c in FRICTION["stands"]])
def test_a_foot_at_rest_on_a_border_moves_as_in_the_references(whole, case):
    run = whole.start(tolerance=1e-13, swing_clamp=1.0, **whole.names(case["given"] | case["start"])).to(0.0)
    way = {"slip": "+" if run.way > 0 else "-"}
    assert run.mode.split("_")[0] + way.get(run.mode.split("_")[0], "") == case["mode_after_start"]
    world = run.to(case["time"]).world()
    assert [world[name] for name in MECHANICAL] == pytest.approx(case["state"], abs=1e-12)


def instants(page):
    """An instant of every mode that some strides on a slope reach, with wind and without."""
    found, values = (
        {},
        {"ground_slope": 0.02, "slope": 0.02, "static_ratio": 1.3, "thrust": 0.02, "seen_y": 1},
    )
    for friction, layer, clamp, wind in (0.3, 0.1, 1, 1e-4), (0.6, 0.1, 0, 0), (10, 0, 1, 0), (0.1, 0, 0, 0):
        values |= {"friction": friction, "stribeck_velocity": layer, "swing_clamp": clamp}
        run = page.start(**values, external_fx=wind, retraction_rate=0.01)
        for time in np.arange(0.1, 30.0, 0.02):
            if run.to(time).outcome != "arrived":
                break
            found.setdefault(run.mode, (run.run.mode, run.p.copy(), run.x.copy(), run.page()))
    return found.items()


def map_along(page, kind, mode, p, x, dp, dx, step=1e-3):
    """The derivative of a map along a direction, by differences of sixth order."""
    ends = {i: page.map(kind, mode, p + i * step * dp, x + i * step * dx) for i in (1, 2, 3, -1, -2, -3)}
    return sum(weight * (ends[i] - ends[-i]) for i, weight in ((1, 45), (2, -9), (3, 1))) / (60 * step)


def test_the_world_seen_from_every_mode_its_rates_and_all_variations(whole):
    random, kinds = np.random.default_rng(5), set()
    states = whole.model.quantities("state")
    for name, (mode, p, x, page) in instants(whole):
        kinds.add(page.mode)
        function = whole.model.marked("is_mode")[page.mode]
        own, world = ([of in (states[n].of or ()) for n in whole.states] for of in (function.of, "world"))
        at_world = whole.map("to_world", mode, p, x)
        assert whole.map("from_world", mode, p, at_world)[own] == pytest.approx(x[own], abs=1e-13), name
        rates = {n: getattr(page, f"{n}_rate") for n, q in states.items() if q.is_input} | function(page)
        moves = np.array([rates.get(n, 0.0) for n in whole.states])
        found = map_along(whole, "to_world", mode, p, x, 0 * p, moves)
        assert whole.map("world_rates", mode, p, x)[world] == pytest.approx(found[world], abs=1e-10), name
        dp, dx = random.uniform(-1, 1, len(p)) * p, random.uniform(-1, 1, len(x))
        dx[[states[n].values is not float for n in whole.states]] = 0.0  # numbers that select a law
        maps = {"to_world": (x, world), "from_world": (at_world, own), "world_rates": (x, world)}
        for kind, (at, written) in maps.items():
            exact = whole.map(kind, mode, p, at, dp, dx)[written]
            found = map_along(whole, kind, mode, p, at, dp, dx)[written]
            assert exact == pytest.approx(found, abs=1e-8 * (1 + abs(found).max())), (name, kind)
    assert kinds == {"flight", "stick", "slip", "graze"}


def test_outputs_of_c_are_those_of_the_page_on_plain_numbers(whole):
    run = whole.start(friction=0.6, **world_of(GAIT["apex"]))
    for time in (0.0, 5.0, 12.2, 12.6, 12.85, 13.0, 13.15, 20.0):
        at, outputs = run.to(time).page(), run.outputs
        assert outputs == pytest.approx({name: float(getattr(at, name)()) for name in outputs}, abs=1e-13)


# ---- differences between engines that random runs found, settled by the model's text -------------------


def test_a_ramp_of_the_friction_coefficient_ends_at_0(whole):
    run = whole.start(friction=0.3, friction_rate=-0.1, seeds=["friction_rate"]).to(5.0)
    assert (run.friction, run.friction_rate) == (0, 0)
    assert run.d("friction") == pytest.approx([0.0], abs=0)
    assert [time for time, name, *_ in run.log if name == "ramp_ends"] == pytest.approx([3.0], abs=1e-11)


@pytest.mark.parametrize(("more", "longer"), [(-0.05, 0.0), (-0.005, 0.015), (0.01, 0.03)])
def test_thrust_makes_no_leg_shorter(whole, more, longer):
    given = {"thrusting": 1, "thrust": 0.02, "more_thrust": more}
    assert Runner.at("stick", **given).rest_length() == pytest.approx(1 + longer, abs=1e-15)


def test_a_second_apex_closes_a_stride_after_the_lowest_rise(whole):
    """An external force lifts the centre of mass by 1e-13 and pulls it down again: place begins anew."""
    weight, push, time = 1.1 * 0.01, 1e-8, 1e-2
    given = {"external_fy": weight + push, "external_fy_rate": -2 * push / time, "retraction_rate": 0.01}
    run = whole.start(**given, tolerance=1e-13, seen_vy=whole.start().seen_vy).to(5.0)
    assert [at for at, name, *_ in run.log if name == "apex"] == pytest.approx([time], abs=1e-7)
    assert (run.count, run.placing) == (1, pytest.approx(5.0 - time, abs=1e-4))


def test_the_time_in_place_is_0_in_other_phases(whole):
    run, placings = whole.start(tolerance=1e-11), {}
    for time in np.arange(0.1, 26, 0.1):
        run.to(time)
        is_placing = run.mode.startswith(("flight", "graze")) and run.swing > 1
        placings.setdefault(is_placing, []).append(run.placing)
    assert max(placings[False]) == 0
    assert min(placings[True]) > 0


def test_peaks_are_the_largest_forces_of_modes_that_last(whole):
    """A torque jumps while the foot sticks on a slope: the foot slips, and the forces jump."""
    world = world_of(GAIT["apex"])
    run, forces = whole.start(ground_slope=0.05, friction=0.4, tolerance=1e-12, **world).to(0.0), []
    for time in np.arange(0.01, 16.0, 0.01):
        if "stick" in run.mode and run.more_torque == 0:
            run.set(more_torque=0.1)
        outputs = run.to(time).outputs
        forces.append([outputs["normal_force"], outputs["ground_force_y"]])
    peaks = [run.peak_force_so_far, run.vertical_so_far]
    assert run.more_torque == 0.1
    assert peaks == pytest.approx(np.max(forces, axis=0), rel=2e-3)
    assert (peaks >= np.max(forces, axis=0)).all()


def test_a_gait_word_of_more_letters_than_a_double_holds_keeps_the_first_and_is_negative():
    known, cut, r = 0, 0, Runner.at("stick", word_so_far=0.0, last_letter=0.0, bar_is_due=0.0)
    for letters in range(1, 60):
        mode, digit = ("slip", 3 if letters % 4 == 1 else 1) if letters % 2 else ("stick", 2)
        law = {"law": "constant"} if mode == "slip" else {}
        kept = {n: getattr(r, n) for n in ("word_so_far", "last_letter", "bar_is_due", "stance_so_far")}
        r = Runner.at(mode, **law, way=digit - 2, time=letters, mode_began=letters - 1, **kept)
        r, known = r.leaving(1), 4 * known + digit
        cut = known if letters <= 26 else cut
        assert r.word_so_far == (known if letters <= 26 else -cut), letters


@pytest.mark.parametrize("foot_mass", [0.1, 1e-4, 1e-7])
@pytest.mark.parametrize("rate", [1e-3, -1e-3])
def test_a_foot_that_bears_nothing_after_its_impact_stays_or_leaves_once(whole, foot_mass, rate):
    """A runner without gravity, damping and servo rests after the impact, until a torque starts."""
    angle, speed = -0.3, 0.1
    start = {"seen_y": 0, "seen_vx": 0, "seen_vy": -speed, "length": 1, "angle": angle,
             "length_rate": speed * np.cos(angle), "angle_rate": -speed * np.sin(angle)}  # fmt: skip
    given = {"gravity": 0, "damping": 0, "kp": 0, "kd": 0, "drive_torque": 0, "friction": 10}
    run = whole.start(**start, **given, foot_mass=foot_mass, external_torque_rate=rate, tolerance=1e-13)
    run.to(0.1 * np.sqrt(foot_mass))
    names = [name for _, name, *_ in run.log if name in ("begins", "lift_off", "touchdown")]
    assert names == (["begins"] if rate > 0 else ["begins", "lift_off"])
    assert all(time == 0 for time, *_ in run.log)
    if rate < 0:  # m_f y''' is the rate of the force, because the leg has hardly moved
        height = rate * np.sin(angle) * run.time**3 / (6 * foot_mass)
        assert run.world()["seen_y"] == pytest.approx(height, rel=2e-2)


# ---- patches and tables of ground ------------------------------------------------------------------------


FAR = 1e12
"""The end of the world."""


def assert_varies(start, vary):
    """Checks the derivatives of the section at the next apex against differences.

    `start` makes a run with something shifted, and `vary` one that varies it as its only seed.
    """
    ends = [section(start(size).to(stop="apex")) for size in (1e-5, -1e-5)]
    run = vary().to(stop="apex")
    exact = np.array([run.d(name)[0] for name in SECTION])
    assert np.abs(exact).max() > 1e-3
    assert exact == pytest.approx((ends[0] - ends[1]) / 2e-5, abs=1e-6 * (1 + np.abs(exact).max()))


@pytest.mark.parametrize("seed", ["patch_begin", "patch_end", "patch_friction", "friction"])
def test_derivatives_by_a_patch_are_those_of_differences(whole, seed):
    given = {"friction": 0.6, "patch_begin": 13.4, "patch_end": 13.5, "patch_friction": 0.05}
    given |= {"tolerance": 1e-14, **world_of(GAIT["apex"])}
    assert_varies(
        lambda size: whole.start(**given | {seed: given[seed] + size}),
        lambda: whole.start(seeds=[seed], **given),
    )


@pytest.mark.parametrize("entry", [(0, 1), (1, 2), (1, 3), (1, 4)])
def test_derivatives_by_entries_of_a_table_are_those_of_differences(whole, entry):
    """A border in mid-slip, and height, slope and friction of the segment of the landing."""
    border = 13.5 if entry == (0, 1) else 5.0
    rows = np.array([[-FAR, border, 0, 0, 0.5], [border, FAR, -0.02, 0.01, 0.3]])
    given = {"friction": 0.6, "tolerance": 1e-14, **world_of(GAIT["apex"])}
    direction = np.zeros_like(rows)
    direction[entry] = 1
    direction[1, 0] = direction[0, 1]  # where one ends, the other begins

    def varied():
        run = whole.start(seeds=["friction"], tables={"ground_segment": rows}, **given)
        run.dx[0] = 0  # the table varies, and nothing else
        run.vary_table(0, direction)
        return run

    assert_varies(
        lambda size: whole.start(tables={"ground_segment": rows + size * direction}, **given), varied
    )


# ---- margins and limits ----------------------------------------------------------------------------------


def trace_with_margins(page, number, nudge=0.0):
    """World states along a random run of a page, the events, and the states' units.

    `nudge` changes the start's leg length.
    """
    parameters, inputs, world, segments, (length, rate, force) = drawn(number)
    given = page.names(parameters | inputs) | world | {"length": world["length"] * (1 + nudge)}
    run = page.start(swing_clamp=number % 2, tolerance=1e-13, step_limit=STEP_LIMIT, **given).to(0.0)
    units = {"m": length, "m/s": length * rate, "rad/s": rate, "J": force * length, "s": 1 / rate, "N": force}
    scales = np.array([units.get(q.unit, 1.0) for q in page.model.quantities("state").values()])
    places, rows, until = [page.states.index(name) for name in STATES], [], 0.0
    for duration, sets, rates in segments:
        run.set(**page.names(sets), **{f"{name}_rate": v for name, v in page.names(rates).items()})
        until += duration
        if run.to(until).outcome != "arrived":
            break
        rows.append(page.map("to_world", run.run.mode, run.p, run.x)[places])
    events = [name for _, name, *_ in run.log]
    return np.reshape(rows, (-1, len(STATES))), events, scales[places]


def off_by(rows, others, units):
    """The largest difference of a state, in the runner's units; infinite for runs of other lengths."""
    if len(rows) != len(others):
        return np.inf
    return (np.abs(rows - others) / units / (1 + np.abs(others))).max(initial=0)


def test_no_result_depends_on_a_margin(monkeypatch):
    """Runs with all margins times 0.1 or 10 differ by a hundred times rounding at most."""
    pages = {1.0: whole_page()}
    for factor in (0.1, 10.0):
        for name, margin in MARGINS.items():
            monkeypatch.setitem(MARGINS, name, margin * factor)
        pages[factor] = CompiledPage(Runner, macros=f"-DTDMF_MARGIN_FACTOR={factor}")
        monkeypatch.undo()
    faults, sensitive = [], 0
    for number in some_of(range(1000), 12):
        rows, events, units = trace_with_margins(pages[1.0], number)
        nudged, *_ = trace_with_margins(pages[1.0], number, 1e-15)
        by_rounding = off_by(rows, nudged, units)
        if by_rounding > 1e-10:  # chaotic
            sensitive += 1
            continue
        for factor in (0.1, 10.0):
            others, taken, _ = trace_with_margins(pages[factor], number)
            off = off_by(rows, others, units) if taken == events else np.inf
            if off > 1e-12 + 100 * by_rounding:
                faults.append(f"{number} times {factor}: {off}, allowed {1e-12 + 100 * by_rounding}")
    assert not faults, "\n".join(faults)
    assert sensitive <= 20


def test_a_return_map_of_too_many_seeds_is_refused(whole):
    seeds = ["friction", "kp", "kd", "gravity", "damping", "stiffness", "body_mass", "foot_mass"]
    seeds += ["free_length", "drive_torque", "touchdown_angle"]
    at_apex = whole.section("at_apex", seeds=seeds[:10])
    assert at_apex.after(GAIT["apex"], varies=True).outcome == "stopped"
    at_apex = whole.section("at_apex", seeds=seeds)
    assert at_apex.after(GAIT["apex"], varies=True).outcome == "too-many-seeds"
    at_apex.given.outcome = at_apex.outcome
    text = "The return map has 11 seeds; with its coordinates, at most 16 are allowed"
    assert at_apex.given.message == text
    assert at_apex.after(GAIT["apex"]).outcome == "stopped"
    assert np.isnan(at_apex.memory[-BEHIND:]).all()
