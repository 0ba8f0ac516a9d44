"""Ground that varies by the table of segments: a patch, a profile, drawn steps, beside the native solver."""

import ctypes

import numpy as np
import pytest
from native_runs import STATES, NativeRun, lasting
from page_runs import COMPILER, TableStruct
from tdmf_slip import Profile
from tdmf_slip.library.binding import c
from test_page_runner import GAIT, SECTION, difference, section, world_of
from test_page_whole import whole  # noqa: F401

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
FAR = 1e12
COLUMNS = ("begin", "end", "height", "slope", "friction")
INPUT = -1.0
"""Stands for `ground.friction` in a table of segments."""


def segments_of(profile):
    """The table of segments of a profile, whose risers are borders. It begins with level ground."""
    borders = np.unique(profile.x)
    middles = [borders[0] - 1, *(borders[1:] + borders[:-1]) / 2, borders[-1] + 1]
    lines = [profile.line(x) for x in middles]
    ends = [-FAR, *borders, FAR]
    return [[*ends[i : i + 2], line.height, line.slope, INPUT] for i, line in enumerate(lines)]


def ways_of(page, given, times, **more):
    """States of the world at these times, and the run."""
    run, rows = page.start(tolerance=1e-13, **given, **more), []
    for time in times:
        run.to(time)
        rows.append(run.world())
    return rows, run


def native_run(page, given, inputs, **parameters):
    """A run of the native solver, with values by the page's names."""
    start = [given[n] for n in STATES[:8]]
    return NativeRun(parameters, {"ground.friction": given["friction"], **inputs}, start, 1e-13)


def assert_same(page, mine, theirs, run, native, until):
    scales = dict.fromkeys(("m", "m/s", "rad", "rad/s", "J", "s"), 1.0)
    worst = max(difference(page, *pair, scales) for pair in zip(mine, theirs, strict=True))
    assert worst[0] < 1e-9, worst
    entered = [lasting(modes, 1.0, until) for modes in (run.modes_entered(), native.modes)]
    assert [row[1:] for row in entered[0]] == [row[1:] for row in entered[1]]
    assert [row[0] for row in entered[0]] == pytest.approx([row[0] for row in entered[1]], abs=1e-9)


PROFILES = {
    "steps": Profile.steps([3.0, 16.0, 27.0, 41.0], [0.0, 0.05, -0.04, 0.1, 0.02]),
    "a ramp": Profile([4.0, 30.0, 50.0], [0.0, 1.3, 0.4]),
    "many lines": Profile(np.arange(0.0, 90.0, 1.3), 0.1 * np.sin(np.arange(0.0, 90.0, 1.3))),
    "a high step": Profile.steps([12.5], [0.0, 0.7]),
}


@pytest.mark.parametrize("name", PROFILES)
def test_runs_over_a_profile_are_those_of_the_native_solver(whole, name):  # noqa: F811
    """The native solver gets the line below the foot at each of many instants, as the unit does."""
    profile, times = PROFILES[name], np.arange(0.05, 70.0, 0.05)
    given = {"friction": 0.6, **world_of(GAIT["apex"])}
    mine, run = ways_of(whole, given, times, tables={"ground_segment": segments_of(profile)})
    native, theirs = native_run(whole, given, {}), []
    for time in times:
        line = profile.line(native.state["seen_x"])
        if (line.height, line.slope) != (native.inputs.ground.height, native.inputs.ground.slope):
            native.set(inputs={"ground.height": line.height, "ground.slope": line.slope})
        theirs.append(native.to(time).state)
    assert native.outcome == 0
    assert run.segment > 0
    assert_same(whole, mine, theirs, run, native, times[-1])


def test_a_patch_is_three_segments(whole):  # noqa: F811
    times = np.arange(0.05, 60.0, 0.05)
    patch = {"patch_begin": 13.4, "patch_end": 13.5, "patch_friction": 0.05}
    given = {"friction": 0.6, "static_ratio": 1.2, **world_of(GAIT["apex"])}
    rows = [[-FAR, 13.4, 0, 0, INPUT], [13.4, 13.5, 0, 0, 0.05], [13.5, FAR, 0, 0, INPUT]]
    by_table, run = ways_of(whole, given, times, tables={"ground_segment": rows})
    by_page, other = ways_of(whole, given | patch, times)
    assert by_table == by_page
    assert run.log == other.log
    assert [name for _, name, *_ in run.log].count("crosses_border") >= 2
    parameters = {"ground." + name: value for name, value in patch.items()}
    native = native_run(whole, given, {}, **parameters, **{"ground.static_friction_ratio": 1.2})
    assert_same(whole, by_page, [native.to(time).state for time in times], run, native, times[-1])


@pytest.mark.parametrize("runner", [0, 3])
def test_drawn_steps_come_at_apices_as_in_the_native_solver(whole, runner):  # noqa: F811
    """Each apex has a step of its own, drawn by the number of the stride in a function of the run."""
    seed, roughness, times, strides = 7, 0.05, np.arange(0.05, 120.0, 0.05), 6
    heights = np.cumsum([roughness * c.tdmf_ground_step(seed, runner, i) for i in range(strides)])
    asked = []

    def entry(_, row, column):
        asked.append(row)
        return [-FAR, FAR, heights[int(np.clip(row, 0, strides - 1))], 0.0, INPUT][column]

    table = TableStruct()
    table.entry = TableStruct._fields_[4][1](entry)
    given = {"friction": 0.6, **world_of(GAIT["apex"])}
    run = whole.start(by_stride=1, tolerance=1e-13, **given)
    run.run.tables = ctypes.addressof(table)
    native, theirs, mine, closed = native_run(whole, given, {}), [], [], -1
    for time in times:
        if native.motion.record.stride.count > closed:
            closed = native.motion.record.stride.count
            native.set(inputs={"ground.height": heights[min(closed, strides - 1)]})
        theirs.append(native.to(time).state)
        mine.append(run.to(time).world())
    assert run.count == native.motion.record.stride.count >= 4
    assert run.segment == run.count
    assert set(asked) >= set(range(5))
    assert_same(whole, mine, theirs, run, native, times[-1])


@pytest.mark.parametrize("seed", ["patch_begin", "patch_end", "patch_friction", "friction"])
def test_derivatives_by_a_patch_are_those_of_differences(whole, seed):  # noqa: F811
    given = {"friction": 0.6, "patch_begin": 13.4, "patch_end": 13.5, "patch_friction": 0.05}
    given, step = given | world_of(GAIT["apex"]), 1e-5
    ends = [
        section(whole.start(tolerance=1e-14, **given | {seed: given[seed] + size}).to(stop="apex"))
        for size in (step, -step)
    ]
    run = whole.start(tolerance=1e-14, seeds=[seed], **given).to(stop="apex")
    exact = np.array([run.d(name)[0] for name in SECTION])
    assert np.abs(exact).max() > 1e-3
    assert exact == pytest.approx((ends[0] - ends[1]) / (2 * step), abs=1e-6 * (1 + np.abs(exact).max()))


@pytest.mark.parametrize("entry", [(0, 1), (1, 2), (1, 3), (1, 4)])
def test_derivatives_by_entries_of_a_table_are_those_of_differences(whole, entry):  # noqa: F811
    """A border in mid-slip, and height, slope and friction of the segment of the landing."""
    border = 13.5 if entry == (0, 1) else 5.0
    rows = np.array([[-FAR, border, 0, 0, 0.5], [border, FAR, -0.02, 0.01, 0.3]])
    given, step, ends = {"friction": 0.6, **world_of(GAIT["apex"])}, 1e-5, []
    direction = np.zeros_like(rows)
    direction[entry] = 1
    direction[1, 0] = direction[0, 1]  # where one ends, the other begins
    for size in (step, -step):
        run = whole.start(tolerance=1e-14, tables={"ground_segment": rows + size * direction}, **given)
        ends.append(section(run.to(stop="apex")))
    run = whole.start(seeds=["friction"], tolerance=1e-14, tables={"ground_segment": rows}, **given)
    run.dx[0] = 0  # the table varies, and nothing else
    run.table_structs[0].d_rows = direction.ctypes.data
    run.to(stop="apex")
    exact = np.array([run.d(name)[0] for name in SECTION])
    assert np.abs(exact).max() > 1e-3
    assert exact == pytest.approx((ends[0] - ends[1]) / (2 * step), abs=1e-6 * (1 + np.abs(exact).max()))


@pytest.mark.parametrize("height", [-0.1, 0.05])
def test_a_foot_that_slips_over_a_border_keeps_its_line(whole, height):  # noqa: F811
    """The foot slips from 13.36 m to 13.57 m; the segment from 13.5 m on is higher, or lower."""
    given = {"friction": 0.6, "tolerance": 1e-13, **world_of(GAIT["apex"])}
    rows = [[-FAR, 13.5, 0, 0, INPUT], [13.5, FAR, height, 0, INPUT]]
    level, run = whole.start(**given), whole.start(tables={"ground_segment": rows}, **given)
    assert section(run.to(stop="apex"))[1:] == pytest.approx(section(level.to(stop="apex"))[1:], abs=1e-11)
    assert "crosses_border" in [name for _, name, *_ in run.log]
