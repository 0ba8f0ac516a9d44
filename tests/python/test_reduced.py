"""The reduced map: gaits against the reference, and the same commands as for the full model."""

import numpy as np
import pytest
from references import read
from tdmf_slip import Batch, InputError, RunError, Runner, basin, find_gait, gait_at, sweep
from tdmf_slip.analysis import attraction
from tdmf_slip.analysis.stability import stability
from tdmf_slip.library.binding import c, ffi
from tdmf_slip.library.section import REDUCED

GAITS = read("reduced_gaits.json")["gaits"]
"""Fixed points in units m = k = l0 = 1, computed independently in extended precision: values to 1e-12,
eigenvalues to 1e-9."""
STRIDES = read("reduced_strides.json")
"""Random strides by an earlier solver for this map alone, with closed forms of both flights."""


def reduced(**values):
    names = {"friction": "ground.friction"}
    return Runner({names[name]: value for name, value in values.items()}, model="reduced")


@pytest.mark.parametrize("gait", GAITS, ids=lambda gait: str(gait["given"]))
def test_gaits_are_those_of_the_reference(gait):
    found = find_gait(gait["given"], guess=gait["apex"], model="reduced")
    assert found.word == gait["word"]
    assert found.apex == pytest.approx(gait["apex"], abs=1e-10)
    for name in ("period", "length", "speed"):
        assert found.stride[name] == pytest.approx(gait[name], rel=1e-10)
    assert found.stride["work"] == pytest.approx(gait["stance_work"], abs=1e-10)
    assert sorted(found.eigenvalues) == pytest.approx(sorted(gait["eigenvalues"]), abs=1e-9)
    assert found.stable and found.error < 1e-11
    assert [letter.letter for letter in found.letters] == list(gait["word"])


def drawn(number):
    """A random runner and its apex; some have no stride."""
    random = np.random.default_rng([47, number])
    u = random.uniform
    values = {
        "foot.mass": 0.1 * 3 ** u(-1, 1), "leg.damping": 0.2 * 2 ** u(-1, 1), "gravity": 0.01 * 3 ** u(-1, 1),
        "hip.stance_torque": 0.2 * 2 ** u(-1, 1), "hip.touchdown_angle": u(-0.2, 1.2),
        "hip.retraction_rate": u(-0.01, 0.02), "leg.thrust": max(0, u(-0.05, 0.05)),
        "ground.static_friction_ratio": max(1, u(0.5, 1.6)), "ground.stribeck_velocity": max(0, u(-0.2, 0.3)),
        "ground.friction": 10 ** u(-1.5, 1), "ground.height": u(-1, 1), "ground.slope": u(-0.1, 0.1),
        "leg.extension": u(-0.02, 0.02), "hip.external_torque": max(0, u(-0.01, 0.005)),
        "body.external_fx": u(-1e-3, 1e-3), "body.external_fy": u(-2e-3, 2e-3),
    }  # fmt: skip
    return Runner(values, model="reduced"), [u(0.6, 2.0), u(-0.1, 1.4)]


def test_random_strides_are_those_of_another_solver():
    seeds = ffi.new("tdmf_seed[3]")
    seeds[0].parameters.foot.mass = seeds[1].inputs.ground.friction = 1.0
    seeds[2].parameters.hip.retraction_rate = 1.0
    for number, (outcome, *expected) in enumerate(STRIDES):
        runner, apex = drawn(number)
        solver = ffi.new("tdmf_solver *", c.tdmf_solver_default())
        solver.relative_tolerance = 1e-13
        point, made = ffi.new("double[]", apex), ffi.new("tdmf_return *")
        request = runner.stride_request(solver, point)
        request.until, request.derivatives, request.seeds, request.seed_count = 1e4, True, seeds, len(seeds)
        c.tdmf_run_stride(request, made)
        name = ffi.string(ffi.cast("tdmf_return_outcome", made.outcome))
        assert name == f"TDMF_RETURN_{outcome.upper().replace(' ', '_')}", number
        if outcome != "closed":
            continue
        word, *values, varied = expected
        stride = made.stride
        found = [made.apex[0], made.apex[1], stride.period, stride.length, stride.work, stride.stance_time,
                 stride.slip_distance, stride.peak_force]  # fmt: skip
        assert ffi.string(stride.word).decode() == word, number
        assert found == pytest.approx(values, rel=1e-9, abs=1e-10), number
        columns = [list(made.variations[k].apex)[:2] for k in range(5)]
        scale = 1 + np.abs(varied).max()
        assert np.array(columns) / scale == pytest.approx(np.array(varied) / scale, abs=1e-9), number
    assert sum(outcome == "closed" for outcome, *_ in STRIDES) > 80


def test_a_gait_is_found_without_a_guess_too():
    assert find_gait(model="reduced").apex == pytest.approx(GAITS[2]["apex"], abs=1e-10)
    assert find_gait({"ground.friction": 0.05}, model="reduced").word == "+-"


@pytest.mark.parametrize(("clamp", "larger", "second"), [(False, 2e-3, 0.13), (True, 1e-3, 0.07)])
def test_the_larger_eigenvalue_is_that_of_the_full_model(clamp, larger, second):
    """The second is near the full model's second, and the words are the same."""
    compared = 0
    for friction in (10.0, 1.2, 0.6, 0.43, 0.2, 0.05):
        given = {"ground.friction": friction, "hip.swing_clamp": clamp}
        full, small = (find_gait(given, model=model) for model in ("full", "reduced"))
        assert small.word == full.word
        assert small.eigenvalues[0] == pytest.approx(full.eigenvalues[0], abs=larger)
        assert small.eigenvalues[1] == pytest.approx(full.eigenvalues[1], abs=second)
        assert small.stride["speed"] == pytest.approx(full.stride["speed"], rel=5e-3)
        compared += 1
    assert compared == 6


def test_a_sweep_has_the_borders_of_the_reduced_map():
    gaits, borders = sweep(reduced(), {"friction": [1.2, 0.6, 0.5, 0.4]})
    assert gaits["word"].values.tolist() == ["+0+", "+0-0+", "+0-0+", "+0-"]
    guess = gait_at(gaits, friction=0.6).apex
    for friction, *words in zip(
        *(borders[name].values for name in ("ground.friction", "before", "after")), strict=True
    ):
        beside = [find_gait(reduced(friction=friction * (1 + s)), guess=guess).word for s in (1e-6, -1e-6)]
        assert beside == words
    assert [borders["before"].values[0], *borders["after"].values] == ["+0+", "+0-0+", "+0-+", "+0-"]


PLANE = {"com_height": (0.8, 3.0), "com_speed": (0.2, 2.0)}


def test_a_basin_is_the_whole_plane(tmp_path):
    data = basin(
        reduced(),
        PLANE,
        12,
        path=tmp_path / "plane.nc",
    )
    assert data.attrs["model"] == "reduced"
    assert 0.9 < data.settled_share < 1.0
    again = basin(
        reduced(),
        PLANE,
        12,
        path=tmp_path / "plane.nc",
    )
    assert np.array_equal(again["fate"], data["fate"])
    found = attraction.attraction_volume(find_gait(model="reduced"), 300)
    assert found.as_json()["box"].keys() == set(REDUCED)
    with pytest.raises(InputError, match="another model"):
        basin(
            Runner(),
            PLANE,
            12,
            path=tmp_path / "plane.nc",
        )


def test_what_makes_no_sense_is_refused():
    with pytest.raises(InputError, match="model 'half'"):
        find_gait(model="half")
    with pytest.raises(InputError, match="com_height, com_speed"):
        find_gait(guess=np.ones(6), model="reduced")
    with pytest.raises(InputError, match="all of one model"):
        Batch([Runner(), reduced()], [[1.0, 1.0]])
    with pytest.raises(InputError, match="rows of com_height, com_speed"):
        Batch(reduced(), np.ones((1, 6)))
    with pytest.raises(RunError, match="there is no apex above the ground"):
        find_gait(guess=[0.3, 1.0], model="reduced")


def test_stability_over_a_plane_is_that_of_each_gait_and_empty_where_there_is_none():
    """A leg that points up touches no ground."""
    angles = [*np.radians([38.0, 40.0, 42.0]), 1.5]
    found = stability(reduced(), {"leg.damping": [0.1, 0.2, 0.3], "hip.touchdown_angle": angles})
    assert np.isfinite(found["lambda_max"].values).tolist() == 3 * [[True, True, True, False]]
    assert (found["word"][:, 3] == "").all()
    for damping in found["leg.damping"].values:
        for angle in angles[:3]:
            values = {"leg.damping": damping, "hip.touchdown_angle": angle}
            gait = find_gait(values, guess=GAITS[2]["apex"], model="reduced")
            at = found.sel(values)
            assert float(at["lambda_max"]) == pytest.approx(gait.lambda_max, abs=1e-9)
            assert at["word"] == gait.word
