"""Viable sets of the slipping runner, against brute force, strides from random points, and finer grids."""

import json
import math
from itertools import product

import numpy as np
import pytest
import tdmf_slip
from conftest import assert_same
from tdmf_slip import InputError
from tdmf_slip.library.batch import ACCURACY
from tdmf_slip.library.return_map import stride_from
from tdmf_slip.viable_sets import viability as viability_sets
from tdmf_slip.viable_sets.grid import starts_at
from tdmf_slip.viable_sets.viability import point_of

STICKING = {"ground.friction": 10.0}
AXES = {"com_height": (0.3, 4.0), "com_speed": (0.0, 4.0)}
VARY = {"hip.touchdown_angle": (0.1, 1.3, 24)}
ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"


@pytest.fixture(scope="module")
def found():
    return tdmf_slip.viability(STICKING, axes=AXES, vary=VARY, n=24)


def pairs_of(found, least=2):
    """Pairs of the inner set, or for level 1 of the outer one, shape (rows, columns, actions)."""
    return found["viable_pair"].values.reshape(*found["viable"].shape, -1) >= least


def states_of(found, least=2):
    return found["viable"].values >= least


def grid_in(found):
    return tdmf_slip.ViableController(found).grid


def runner_of(found):
    return tdmf_slip.Runner(json.loads(found.runner), model=found.model)


def image_of(runner, apex, settings):
    """Next apices by the library's reduced map, one stride at a time, NaN if there is none."""
    try:
        return stride_from(runner.replace(settings), apex, ANGLE)[0]
    except tdmf_slip.RunError:
        return np.full(2, np.nan)


def brute_force(found, images, inner):
    """Brute force by the definitions, cell by cell: pairs of the set by row, column and action."""
    edges, scales, boxes = list(grid_in(found).edges.values()), runner_of(found).scales, {}
    slack = ACCURACY * scales + 2.0**-22 * np.array([np.abs(of).max() for of in edges])
    for row, column, number in np.ndindex(*grid_in(found).cells, len(images)):
        corners = images[number, row : row + 2, column : column + 2]
        known = np.isfinite(corners[..., 0])
        if known.sum() < (4 if inner else 1):
            continue
        half, ranges = slack.copy(), []
        for axis, upper in enumerate((known[1].sum() / known.sum(), known[:, 1].sum() / known.sum())):
            rows, columns = (
                slice(max(at - wide, 0), at + 2 + wide)
                for at, wide in zip((row, column), (axis == 0, axis == 1), strict=True)
            )
            differences = np.abs(np.diff(images[number, rows, columns], axis=axis)).reshape(-1, 2)
            half += found.factor * max(upper, 1 - upper) * np.fmax.reduce(differences)
        for middle, reach, of in zip(corners[known].mean(axis=0), half, edges, strict=True):
            count, side = len(of) - 1, of[1] - of[0]
            if math.isnan(reach):
                ranges.append(range(count))
                continue
            first, last = (math.floor((end - of[0]) / side) for end in (middle - reach, middle + reach))
            beyond = inner and (first < 0 or last >= count)
            ranges.append(range(0) if beyond else range(max(first, 0), min(last, count - 1) + 1))
        if all(map(len, ranges)):
            boxes[row, column, number] = set(product(*ranges))
    while True:
        states = {pair[:2] for pair in boxes}
        kept = {pair: box for pair, box in boxes.items() if (box <= states if inner else box & states)}
        if len(kept) == len(boxes):
            return set(kept)
        boxes = kept


@pytest.mark.parametrize(
    ("friction", "vary"),
    [(10.0, {ANGLE: (0.1, 1.3, 7)}), (0.6, {ANGLE: (0.3, 1.1, 4), TORQUE: (0.02, 0.4, 3)})],
)
def test_brute_force_finds_the_same_pairs(friction, vary):
    axes = {"com_height": (0.5, 3.0), "com_speed": (0.2, 2.5)}
    found = tdmf_slip.viability({"ground.friction": friction}, axes=axes, vary=vary, n=(15, 14), factor=1.1)
    actions = grid_in(found).all_actions()
    chosen = [dict(zip(actions, map(float, one), strict=True)) for one in zip(*actions.values(), strict=True)]
    heights, speeds = grid_in(found).edges.values()
    runner = runner_of(found)
    images = np.array([[[image_of(runner, [h, v], one) for v in speeds] for h in heights] for one in chosen])
    for name, pairs in (("outer", pairs_of(found, 1)), ("inner", pairs_of(found))):
        expected = brute_force(found, images, inner=name == "inner")
        assert set(zip(*map(np.ndarray.tolist, np.nonzero(pairs)), strict=True)) == expected, name
    assert 0 < pairs_of(found).sum() < pairs_of(found, 1).sum() < pairs_of(found, 1).size


def next_apices(runner, points, settings):
    """Fates of single strides from points, each with its settings, 0 for a closed stride, and next apices."""
    inputs = {name: row[:, None] for name, row in settings.items()}
    run = tdmf_slip.Batch(runner, points, inputs=inputs).run(1)
    closed = run.strides == 1
    return np.where(closed, 0, run.fate), np.where(closed[:, None], run.apex, np.nan)


def random_points(grid, cells, count, seed):
    """Random points in some cells, shape (count, 2), and the numbers of their cells."""
    draw = np.random.default_rng(seed)
    chosen = draw.integers(0, len(cells), count)
    corner = cells[chosen][:, :2] * grid.sizes + grid.origin
    return corner + grid.sizes * draw.random((count, 2)), chosen


def test_an_inner_pair_leads_from_all_over_its_cell_into_the_inner_set(found):
    pairs = np.argwhere(pairs_of(found))
    points, chosen = random_points(grid_in(found), pairs, 20_000, 1)
    angles = grid_in(found).all_actions()[ANGLE][pairs[chosen, 2]]
    fates, apices = next_apices(runner_of(found), points, {ANGLE: angles})
    assert (fates == 0).all()
    cells = grid_in(found).cell_of(apices)
    assert (cells >= 0).all()
    assert states_of(found).ravel()[cells].all()


def test_no_action_leads_from_outside_of_the_outer_set_into_it(found):
    outside = np.argwhere(~states_of(found, 1))
    points, _ = random_points(grid_in(found), outside, 2_000, 2)
    angles = grid_in(found).all_actions()[ANGLE]
    fates, apices = next_apices(
        runner_of(found), np.repeat(points, len(angles), axis=0), {ANGLE: np.tile(angles, len(points))}
    )
    cells = grid_in(found).cell_of(apices)
    assert (fates == 0).sum() > 100
    assert not ((cells >= 0) & states_of(found, 1).ravel()[cells]).any()


def test_both_sets_close_on_each_other_as_the_grid_is_refined():
    shares = np.array(
        [
            (of.inner_share, of.outer_share, of["inner_robustness"].mean(), of["outer_robustness"].mean())
            for of in (tdmf_slip.viability(STICKING, axes=AXES, vary=VARY, n=n) for n in (12, 24, 48))
        ]
    )
    for inner, outer in (shares[:, :2].T, shares[:, 2:].T):
        assert (np.diff(inner) > 0).all()
        assert (np.diff(outer) < 0).all()
        gaps = outer - inner
        assert gaps[-1] < 0.6 * gaps[-2] and gaps[-1] < 0.08


def test_the_controller_keeps_runners_up_for_long(found):
    points, _ = random_points(grid_in(found), np.argwhere(states_of(found)), 300, 3)
    law = tdmf_slip.ViableController(found, {ANGLE: 0.5})
    run = tdmf_slip.stride_map(runner_of(found), points, strides=100, law=law)
    assert (run["fate"] == 0).all()
    chosen = run[ANGLE][:, 0]
    cells = grid_in(found).cell_of(points)
    viable = pairs_of(found).reshape(-1, 24)[cells]
    values = grid_in(found).actions[ANGLE]
    nearest = np.where(viable, np.abs(values - 0.5), np.inf).min(axis=1)
    assert np.allclose(np.abs(chosen - 0.5), nearest, rtol=0, atol=1e-12)
    assert len(np.unique(chosen)) > 5
    without = tdmf_slip.stride_map(runner_of(found), points, strides=100, inputs={ANGLE: 0.5})
    assert (without["fate"][:, -1] != 0).mean() > 0.2


def test_the_controller_says_what_it_knows(found):
    law = tdmf_slip.ViableController(found)
    assert law.grade_at([100.0, 1.0]) == "not viable"
    assert law.inputs_at([100.0, 1.0]) == {ANGLE: runner_of(found)[ANGLE]}
    row, column = np.argwhere(states_of(found, 1) & ~states_of(found))[0]
    middle = [grid_in(found).centers(axis)[k] for axis, k in zip(AXES, (row, column), strict=True)]
    assert law.grade_at(middle) == "open"
    assert law.grade_at([1.4, 1.0, 1.0, 0.7, 0.0, 0.0]) == "viable"
    assert law(np.array([[np.nan, np.nan]]))[ANGLE][0] == runner_of(found)[ANGLE]


def test_a_drop_goes_as_far_as_cells_above_are_viable(found):
    inner, outer = (found[f"{name}_drop"].values for name in ("inner", "outer"))
    states, side = states_of(found), grid_in(found).sizes[0]
    for row, column in np.ndindex(states.shape):
        if not states[row, column]:
            assert math.isnan(inner[row, column])
            continue
        above = 0
        while row + above + 1 < len(states) and states[row + above + 1, column]:
            above += 1
        assert inner[row, column] == pytest.approx(above * side, abs=1e-12)
    assert (outer[states] > inner[states]).all()


def test_a_drop_of_the_ground_adds_to_the_height_of_an_apex(found):
    ground = {"ground.height": [0.0, -0.7]}
    run = tdmf_slip.stride_map(runner_of(found), [1.4, 1.0], strides=2, inputs=ground)
    first, second = run["next_apex"].values[0]
    dropped = next_apices(runner_of(found), first[None] + [[0.7, 0.0]], {"ground.height": np.zeros(1)})[1][0]
    assert np.allclose(second, dropped, rtol=0, atol=1e-8)
    assert abs(second[0] - first[0]) > 1e-3


def test_states_that_lead_to_a_gait():
    axes = {"com_height": (1.0, 2.0), "com_speed": (0.6, 1.6)}
    vary = {ANGLE: (0.3, 1.1, 24), TORQUE: (0.05, 0.4, 12)}
    asked = {"axes": axes, "vary": vary, "n": 24}
    gait = tdmf_slip.find_gait({"ground.friction": 0.6}, model="reduced")
    found = tdmf_slip.viability(gait, **asked, gait=gait)
    target, inner, outer = (found[name].values for name in ("at_gait", "inner_strides", "outer_strides"))
    cell = np.unravel_index(grid_in(found).cell_of(gait.apex[None])[0], grid_in(found).cells)
    assert target.sum() == 25
    assert target[cell]
    assert inner[cell] == 0
    assert (outer >= 0).mean() >= (inner >= 0).mean() > 0.9
    assert (outer[inner >= 0] <= inner[inner >= 0]).all()
    points, _ = random_points(grid_in(found), np.argwhere(inner == 2), 100, 5)
    actions = grid_in(found).all_actions()
    settings = {name: np.tile(values, len(points)) for name, values in actions.items()}
    starts = np.repeat(points, grid_in(found).action_count, axis=0)
    _, apices = next_apices(runner_of(found), starts, settings)
    cells = grid_in(found).cell_of(apices)
    strides = np.where(cells >= 0, inner.ravel()[cells], -1).reshape(len(points), -1)
    assert ((strides >= 0) & (strides <= 1)).any(axis=1).all()
    with pytest.raises(InputError, match="no cell is near"):
        tdmf_slip.viability(gait, **asked, gait=[40.0, 1.0])


def test_the_full_model_starts_where_the_last_placement_leaves_the_leg():
    axes = {"com_height": (0.8, 3.0), "com_speed": (0.2, 2.0)}
    settings = {"axes": axes, "vary": {ANGLE: (0.3, 1.1, 12)}, "n": 20}
    full = tdmf_slip.viability({"ground.friction": 0.6}, model="full", **settings)
    reduced = tdmf_slip.viability({"ground.friction": 0.6}, **settings)
    starts = starts_at(point_of(runner_of(full), tuple(axes), None), [0, 1], np.array([[1.4, 1.0]]))
    assert starts.tolist() == [[1.4, 1.0, 1.0, runner_of(full)[ANGLE], 0.0, 0.0]]
    assert 0.3 < full.inner_share <= full.outer_share
    images = [np.stack([of[f"next_{axis}"].values for axis in axes]) for of in (full, reduced)]
    difference = np.abs(images[0] - images[1])[np.isfinite(images).all(axis=0)]
    assert 0 < np.median(difference) < 0.02
    node = images[0][:, 4, 5, 3]
    height, speed = (edges[k] for edges, k in zip(grid_in(full).edges.values(), (4, 5), strict=True))
    apex = [height, speed, 1.0, runner_of(full)[ANGLE], 0.0, 0.0]
    alone = stride_from(runner_of(full).replace({ANGLE: grid_in(full).actions[ANGLE][3]}), apex, ANGLE)[0][:2]
    assert np.allclose(node, alone, rtol=0, atol=1e-6)


def test_the_dataset_has_shares_and_pairs(found):
    assert found["viable"].dims == ("com_height", "com_speed")
    assert np.array_equal(found["viable"], found["viable_pair"].max((ANGLE,)))
    assert found["viable_pair"].dims == ("com_height", "com_speed", ANGLE)
    assert found["next_com_speed"].shape == (25, 25, 24)
    assert float(found["com_height"][0]) == pytest.approx(0.3 + 0.5 * 3.7 / 24)
    assert np.array_equal(found["inner_robustness"].values, pairs_of(found).sum(axis=2) / 24)
    assert found.inner_share == (found["inner_robustness"].values > 0).mean()
    assert (pairs_of(found) <= pairs_of(found, 1)).all()
    axes = {"com_height": (0.05, 0.3), "com_speed": (0.0, 0.2)}
    nothing = tdmf_slip.viability(STICKING, axes=axes, vary={ANGLE: (0.0, 0.5, 4)}, n=5)
    assert not pairs_of(nothing, 1).any() and nothing.outer_share == 0.0
    assert tdmf_slip.ViableController(nothing).grade_at([0.1, 0.1]) == "not viable"


def test_strides_are_kept_once(monkeypatch):
    images, boxes_of = [], viability_sets.boxes_of

    def seen(grid, of, *given, **named):
        images[:] = of
        return boxes_of(grid, of, *given, **named)

    monkeypatch.setattr(viability_sets, "boxes_of", seen)
    actions = {"hip.touchdown_angle": (0.3, 1.1, 3)}
    made = tdmf_slip.viability(axes={"com_height": (1.0, 2.0), "com_speed": (0.6, 1.6)}, vary=actions, n=4)
    for image, name in zip(images, ("next_com_height", "next_com_speed"), strict=True):
        assert np.shares_memory(image, made[name].values)


def test_a_file_that_is_whole_is_read_again(found, tmp_path):
    path = tmp_path / "viable.nc"
    for _ in range(2):
        assert_same(tdmf_slip.viability(STICKING, axes=AXES, vary=VARY, n=24, path=path), found)
        assert [file.name for file in tmp_path.iterdir()] == ["viable.nc"]
    with pytest.raises(InputError, match=r"not this viable set: another ground\.friction"):
        tdmf_slip.viability({"ground.friction": 9.0}, axes=AXES, vary=VARY, n=24, path=path)


GOOD = {"axes": AXES, "vary": VARY, "n": 4}


@pytest.mark.parametrize(
    ("bad", "message"),
    [
        ({"axes": {"com_height": (1, 2)}}, "axes: without com_speed"),
        ({"axes": {"com_height": (1, 2), "leg_angle": (0, 1)}}, "axes: 'leg_angle' is not allowed"),
        ({"axes": {"com_height": (2, 1), "com_speed": (0, 1)}}, "axes: com_height = .2, 1. is not allowed"),
        ({"axes": {"com_height": "12", "com_speed": (0, 1)}}, "axes: com_height"),
        ({"axes": 3}, "axes = 3 is not allowed"),
        ({"vary": {}}, "vary: nothing"),
        ({"vary": {"hip.torque": (0, 1)}}, "'hip.torque' is not a setting"),
        ({"vary": {"body.mass": (1, 2)}}, "body.mass cannot change in a run"),
        ({"vary": {"hip.kp": (0, 1)}}, "hip.kp has no effect in the reduced map"),
        ({"vary": {ANGLE: (0, 1, 0)}}, "vary: hip.touchdown_angle: values = 0"),
        ({"vary": {ANGLE: (0, 9)}}, "hip.touchdown_angle = "),
        ({"vary": {ANGLE: (0, 0.5, 3, 4)}}, "vary: hip.touchdown_angle"),
        ({"vary": {"ground.friction": (-1, 1)}}, "ground.friction = -1 is not allowed"),
        ({"n": (4, 4, 4)}, "n = "),
        ({"n": 2.5}, "n = 2.5 is not allowed"),
        ({"n": 2048, "vary": {ANGLE: (0, 1, 100)}}, "419,840,100 strides"),
        ({"factor": math.nan}, "factor = nan is not allowed"),
        ({"model": "half"}, "model 'half' is not allowed"),
        ({"executor": 2}, "executor = 2 is not allowed"),
        ({"path": "viable.csv"}, "viable.csv"),
        *(
            ({"runner": {"ground.patch_end": 3.0}, "model": of}, "patch_end = 3")
            for of in ("full", "reduced")
        ),
        ({"wish": {"hip.kp": 1.0}}, "wish: 'hip.kp' is not allowed; allowed: hip.touchdown_angle"),
        ({"wish": {ANGLE: "much"}}, "wish: hip.touchdown_angle = much is not allowed"),
        ({"apex": [1.4]}, "apex = .1.4. is not allowed; allowed: the coordinates of an apex"),
        ({"apex": "a"}, "apex = 'a' is not allowed"),
    ],
)
def test_what_is_not_allowed_is_refused(found, bad, message):
    with pytest.raises(InputError, match=message):
        if "apex" in bad:
            tdmf_slip.ViableController(found).inputs_at(**bad)
        if "wish" in bad:
            tdmf_slip.ViableController(found, **bad)
        tdmf_slip.viability(**({"runner": STICKING} | GOOD | bad))
