"""Terrain: level segments of which the foot meets the one below it, against ground set by stride."""

import numpy as np
import pytest
from tdmf_slip import AffineLaw, Batch, stride_map, strides_to_fall
from tdmf_slip.library.engine import FATES, instruction_sets
from tdmf_slip.library.ground import RoughGround, correlated_weights, spectrum_weights

FELL, UNDECIDED = FATES.index("fell"), FATES.index("undecided")
TOUCHDOWN, LIFTOFF = 13.8292, 14.0363
"""Places where the foot of the gait at friction 0.6 first lands and lifts off, from its start, m."""


def runs(gait, ground, runners=1, strides=3, **how):
    starts = np.tile(gait.apex, (runners, 1))
    how = {"tolerance": 1e-11, **how}
    return Batch(gait.runner, starts, ground, **how).run(strides)


def one_run(gait, ground, strides=3):
    return Batch(gait.runner, gait.apex, ground, tolerance=1e-11).run(strides)


def by_stride(gait, heights):
    """The first is that of the start, above which its apex is."""
    data = stride_map(
        gait.runner, [gait.apex], strides=len(heights), inputs={"ground.height": np.array([heights])}
    )
    return data["next_apex"].values[0, -1]


@pytest.mark.parametrize("length", [0.7, 2.0, 30.0])
def test_segments_without_heights_change_no_bit(gait, length):
    level = runs(gait, RoughGround(), strides=10)
    segments = runs(gait, RoughGround(segment_length=length), strides=10)
    for name in level:
        np.testing.assert_array_equal(level[name], segments[name], err_msg=name)


def test_segments_as_long_as_strides_are_steps_by_stride(gait):
    steps = RoughGround(0.05, 3)
    length = float(gait.stride["length"])
    for runner in range(4):
        heights = np.cumsum(steps.steps(runner, 5))
        # Runner 0 of the terrain begins on its first segment, which is its own level.
        ground = RoughGround(segment_length=length, heights=tuple(heights))
        on_terrain = one_run(gait, ground, strides=4)
        # Apices are above an edge, and on which side of it tells only their height.
        assert on_terrain["apex"][1:] == pytest.approx(
            by_stride(gait, heights[:4] - heights[0])[1:], abs=1e-8
        )


def test_the_segment_below_the_foot_counts_and_not_its_neighbour(gait):
    level = one_run(gait, RoughGround(), strides=1)["apex"]
    lower = (0.0, -0.1, -0.1, -0.1)
    beyond = one_run(gait, RoughGround(segment_length=TOUCHDOWN + 1e-3, heights=lower), strides=1)["apex"]
    before = one_run(gait, RoughGround(segment_length=TOUCHDOWN - 1e-3, heights=lower), strides=1)["apex"]
    assert beyond[1:] == pytest.approx(level[1:], abs=1e-9)
    assert abs(before[1] - level[1]) > 1e-4


def test_an_edge_belongs_to_the_segment_ahead(gait):
    """The foot starts on the edge of segments 0 and -1, whose height is the last one given."""
    start = one_run(gait, RoughGround(segment_length=50.0, heights=(0.0, 0.4)), strides=1)
    assert start["apex"] == pytest.approx(one_run(gait, RoughGround(), strides=1)["apex"], abs=1e-12)


def test_a_foot_that_slips_over_an_edge_keeps_its_height(gait):
    level = one_run(gait, RoughGround(), strides=1)["apex"]
    length = 0.5 * (TOUCHDOWN + LIFTOFF)
    for height in (-0.1, 0.05):
        heights = (0.0, height, height, height)
        slipped = one_run(gait, RoughGround(segment_length=length, heights=heights), strides=1)
        # The apex is above the segment below the foot, the second or third.
        assert slipped["apex"][0] == pytest.approx(level[0] - height, abs=1e-9)
        assert slipped["apex"][1:] == pytest.approx(level[1:], abs=1e-9)
    tripping = RoughGround(segment_length=length, heights=(0.0, 0.05, 0.05, 0.05), trips=True)
    assert runs(gait, tripping)["fate"][0] == FELL
    falling = RoughGround(segment_length=length, heights=(0.0, -0.05, -0.05, -0.05), trips=True)
    assert runs(gait, falling, strides=1)["fate"][0] == UNDECIDED


@pytest.mark.parametrize(("length", "falls"), [(TOUCHDOWN - 0.3, True), (TOUCHDOWN - 3.0, False)])
def test_a_foot_that_swings_into_a_face_trips_or_is_borne_by_the_segment_it_came_from(gait, length, falls):
    """Within 0.3 m of its touchdown the foot is below 0.1 m, 3 m before it is above."""
    heights = (0.0, 0.1, 0.1, 0.1)
    trips = one_run(gait, RoughGround(segment_length=length, heights=heights, trips=True), strides=1)
    assert (trips["fate"] == FELL) == falls
    passes = one_run(gait, RoughGround(segment_length=length, heights=heights), strides=1)
    level = one_run(gait, RoughGround(), strides=1)["apex"]
    motion = passes["apex"][1:]
    assert (np.abs(motion - level[1:]).max() < 1e-9) == falls


@pytest.mark.parametrize("length", [0.6, 3.0, 40.0])
def test_lanes_make_what_the_native_solver_makes(gait, length):
    ground = RoughGround(0.2, 3, correlated_weights(0.5), segment_length=length, friction_spread=0.2)
    alone = runs(gait, ground, 24, 6, instructions="one by one")
    for instructions in instruction_sets():
        lanes = runs(gait, ground, 24, 6, instructions=instructions)
        assert np.array_equal(lanes["fate"], alone["fate"])
        assert np.array_equal(lanes["strides"], alone["strides"])
        assert lanes["apex"] == pytest.approx(alone["apex"], abs=1e-9)


@pytest.mark.parametrize("weights", [(), correlated_weights(0.8), spectrum_weights([0.0, 1.0, 2.0, 0.5])])
def test_heights_that_are_drawn_are_those_that_are_told(gait, weights):
    drawn = RoughGround(0.1, 5, step_weights=weights, segment_length=1.5)
    # Feet do not come back behind the start by more than a segment, the one that is never looked at here.
    listed = RoughGround(segment_length=1.5, heights=tuple(drawn.segment_heights(0, 400)))
    assert runs(gait, drawn, strides=8)["apex"] == pytest.approx(
        runs(gait, listed, strides=8)["apex"], abs=1e-9
    )


def test_runner_n_begins_on_segment_n(gait):
    heights = (0.0, 0.1, -0.1, 0.05, 0.2)
    both = runs(gait, RoughGround(segment_length=25.0, heights=heights), runners=2)
    second = runs(gait, RoughGround(segment_length=25.0, heights=(*heights[1:], heights[0])))
    assert both["apex"][1] == pytest.approx(second["apex"][0], abs=1e-12)
    assert RoughGround(segment_length=25.0, heights=heights).segment_heights(1, 3) == pytest.approx(
        [0.1, -0.1, 0.05]
    )


@pytest.mark.parametrize("height", [1.3, 1.6])
def test_a_step_that_the_foot_reaches_and_the_centre_of_mass_does_not_is_met(gait, height):
    """The runner falls upright while its leg swings forward over the edge at 1 m, from 0.9 m on."""
    apex = np.array([height, 0.0, 1.0, 0.4, 0.0, 0.0])
    ground = RoughGround(segment_length=1.0, heights=(0.0, 0.1, 0.1))
    stepped = Batch(gait.runner, apex, ground, foot_x=0.9, tolerance=1e-11).run(1)
    level = Batch(gait.runner, apex - [0.1, 0, 0, 0, 0, 0], tolerance=1e-11).run(1)
    assert stepped["strides"] == level["strides"] == 1
    assert stepped["apex"] == pytest.approx(level["apex"], abs=1e-9)


def test_ground_behind_the_start_has_the_last_heights_first(gait):
    """A start on segment -k is one on segment 0 of the heights turned round by k."""
    heights = (0.0, 0.1, -0.1, 0.05, 0.2)
    for back in range(1, 8):
        x = np.array([5.0 - 25.0 * back])
        behind = runs(gait, RoughGround(segment_length=25.0, heights=heights), foot_x=x)
        turned = tuple(np.roll(heights, back))
        at_start = runs(gait, RoughGround(segment_length=25.0, heights=turned), foot_x=np.array([5.0]))
        assert behind["apex"] == pytest.approx(at_start["apex"], abs=1e-9)


def test_friction_is_that_of_the_segment_that_the_foot_comes_down_on(gait):
    """Segments as long as a stride are numbered like strides."""
    length = float(gait.stride["length"])
    on_terrain = runs(gait, RoughGround(0.0, 7, friction_spread=0.2, segment_length=length), strides=4)
    strides = runs(gait, RoughGround(0.0, 7, friction_spread=0.2), strides=4)
    assert on_terrain["apex"] == pytest.approx(strides["apex"], abs=1e-9)
    level = runs(gait, RoughGround(), strides=4)
    assert np.abs(on_terrain["apex"] - level["apex"]).max() > 1e-3


def test_strides_to_fall_counts_on_it(gait):
    rough = strides_to_fall(
        gait.runner, RoughGround(0.3, 1, segment_length=2.0), 200, max_strides=200, gait=gait
    )
    trips = strides_to_fall(
        gait.runner, RoughGround(0.3, 1, segment_length=2.0, trips=True), 200, max_strides=200, gait=gait
    )
    assert rough.unsolved == trips.unsolved == 0
    assert trips.interval[1] < rough.interval[0]


def test_the_command_has_it(tmp_path, command):
    path = tmp_path / "heights.txt"
    path.write_text("0 0.02 -0.02", encoding="utf-8")
    given = ["rough", "--runners", "4", "--max-strides", "4", "--segment-length", "3"]
    printed = command.json(*given, "--heights", path)
    more = ("--correlation", "0.7", "--friction-spread", "0.1", "--trips")
    drawn = command.json(*given, "--roughness", "0.02", *more)
    assert printed["strides"] == drawn["strides"] == 16


@pytest.mark.parametrize("trips", [False, True])
def test_a_function_is_a_law_on_a_terrain_too(gait, trips):
    """Runs stop at each apex and go on, with the same bits as without a stop, also of drawn friction."""
    ground = RoughGround(0.1, 3, segment_length=3.0, trips=trips, friction_spread=0.1)
    starts = np.tile(gait.apex, (40, 1))
    angle = gait.runner["hip.touchdown_angle"]
    law = AffineLaw(["hip.touchdown_angle"], gait.apex, [angle], [[0.05] * 6], [0.5], [0.9])
    by_engine, by_calls = (
        Batch(gait, starts, ground, one).run(12, record=True)
        for one in (law, lambda apices, stride_number: law(apices, stride_number))
    )
    for name in by_engine:
        np.testing.assert_array_equal(by_engine[name], by_calls[name], err_msg=name)
    for name in by_engine.recorded:
        np.testing.assert_array_equal(by_engine.recorded[name], by_calls.recorded[name], err_msg=name)
    assert (by_engine.strides > 2).any() and (by_engine.fate == FELL).any() == trips
