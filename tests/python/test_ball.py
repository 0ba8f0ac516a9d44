"""Balls of attraction: starts inside settle, also points drawn anew, and fates are the same as without."""

import dataclasses

import numpy as np
import pytest
import tdmf_slip
from conftest import RELEASE, in_units, release
from tdmf_slip import Batch, InputError, Runner, basin, find_gait
from tdmf_slip.analysis import ball as balls
from tdmf_slip.analysis.attraction import attraction_volume
from tdmf_slip.analysis.ball import MAX_STRIDES, attributes_of, ball_of, fates, saves_time
from tdmf_slip.library.batch import NEAR
from tdmf_slip.library.engine import SETTLED
from tdmf_slip.library.laws import AffineLaw
from tdmf_slip.proof.prove_attraction import proved_ball

ANGLE = "hip.touchdown_angle"


@pytest.fixture(scope="module", params=(0.6, 0.2, 10.0) if RELEASE else (10.0,))
def gait(request):
    return find_gait({"ground.friction": request.param})


@pytest.fixture(scope="module")
def ball(gait):
    return balls.tested_ball(gait)


def points_in(ball, count, surface=False):
    """Points count from the gait's apex, and are drawn by another seed than the test's."""
    source = np.random.default_rng(20260801)
    size = len(ball.matrix)
    directions = source.normal(size=(count, size))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    radii = 1.0 if surface else source.uniform(0.0, 1.0, size=(count, 1)) ** (1.0 / size)
    return np.linalg.solve(ball.matrix, (radii * directions).T).T


def rates(gait, ball, away):
    """The norm's mean factor in each of two strides; infinite where they do not close."""
    ends = Batch(gait.runner, gait.apex + away, tolerance=1e-8).run(2)
    before, after = (np.linalg.norm(x @ ball.matrix.T, axis=1) for x in (away, ends["apex"] - gait.apex))
    return np.where(ends["strides"] == 2, np.sqrt(after / before), np.inf)


def test_points_of_a_tested_ball_settle_because_the_norm_falls(gait, ball):
    """A sample of its own, each followed by 1e-8 to a hundredth of where a map calls it settled."""
    starts = gait.apex + points_in(ball, 4000 if RELEASE else 500)
    ends = Batch(gait.runner, starts, tolerance=1e-8).run(MAX_STRIDES, gait, near=1e-4)
    assert (ends["fate"] == SETTLED).all()
    slowest = rates(gait, ball, points_in(ball, 4000 if RELEASE else 1000, surface=True)).max()
    assert slowest < 0.5 * (1.0 + ball.rate) < 1.0
    assert ball.rate > gait.lambda_max - 0.01  # near the gait no norm falls faster from everywhere
    corners = np.array(np.meshgrid(*[(-1.0, 1.0)] * 6)).reshape(6, -1).T * ball.radius * gait.runner.scales
    assert np.linalg.norm(corners @ ball.matrix.T, axis=1).max() == pytest.approx(1.0, rel=1e-12)
    assert ball.radius > 0.05  # five times where a start counts as settled without it


def test_a_ball_of_a_scaled_runner_is_scaled(gait, ball):
    runner = in_units(80.0, 20_000.0, 0.9, **{"ground.friction": gait.friction})
    other = balls.tested_ball(find_gait(runner, guess=gait.apex * runner.scales))
    assert other.matrix * runner.scales == pytest.approx(ball.matrix, rel=1e-5, abs=1e-6)
    assert other.radius == pytest.approx(ball.radius, rel=1e-5)


def test_a_larger_ball_of_the_norm_is_none(gait, ball):
    """In a ball half as wide again the norm does not fall enough from some point, or a runner falls."""
    away = points_in(dataclasses.replace(ball, matrix=ball.matrix / 1.5), 5_000, surface=True)
    assert rates(gait, ball, away).max() > gait.lambda_max + 0.75 * (1.0 - gait.lambda_max)


@pytest.mark.parametrize("reduced", [False, True])
def test_fates_are_equal_with_a_ball_and_without(gait, ball, reduced):
    """The map has 24 by 24 starts, or 64 by 64 with --release."""
    count = 64 if RELEASE else 24
    if reduced:
        gait = find_gait(Runner(gait.runner, model="reduced"))
        ball = balls.tested_ball(gait)
    starts = np.tile(gait.apex, (count, count, 1))
    starts[..., 0] = np.linspace(1.0, 4.0, count)[:, None]
    starts[..., 1] = np.linspace(0.0, 2.5, count)[None, :]
    starts = starts.reshape(-1, starts.shape[-1])
    followed, known = fates(gait, starts), fates(gait, starts, ball=ball)
    np.testing.assert_array_equal(known["fate"], followed["fate"])
    fell = followed["fate"] != SETTLED
    assert fell.sum() > (count**2 // 100 if gait.friction > 0.2 and not reduced else -1)  # there all settle
    np.testing.assert_array_equal(known["strides"][fell], followed["strides"][fell])
    assert (known["strides"] <= followed["strides"]).all()
    assert 2.0 * known["strides"][~fell].sum() < followed["strides"][~fell].sum()
    assert attraction_volume(gait, 500, ball=ball) == attraction_volume(gait, 500, ball="none")


def test_a_ball_is_of_the_runner_under_its_law(gait, ball):
    """Under a law points of its ball settle; without the law the runner has another one."""
    gain, angle = np.zeros((1, 6)), gait.runner[ANGLE]
    gain[0, 1] = 0.05
    law = AffineLaw((ANGLE,), gait.apex, [angle], gain, [angle - 0.2], [angle + 0.2])
    under_law = balls.tested_ball(gait, law)
    assert under_law is not None and not np.allclose(under_law.matrix, ball.matrix, rtol=1e-3)
    ends = Batch(gait.runner, gait.apex + points_in(under_law, 500), law=law).run(200, gait, near=1e-4)
    assert (ends.fate == SETTLED).all()
    assert balls.tested_ball(gait, dataclasses.replace(law, noise=[0.01] * 6)) is None


def test_a_ball_is_made_only_where_it_saves_more_than_it_costs(gait, ball):
    assert not saves_time(gait, 400) and saves_time(gait, 128 * 128)
    assert ball_of(gait, "tested", 400) is None
    with pytest.raises(InputError, match="has 2 coordinates; allowed: 6"):
        ball_of(gait, dataclasses.replace(ball, matrix=np.eye(2)), 10)
    assert attributes_of(None) == {"ball": "none"}
    with pytest.raises(InputError, match="tested, none, or a Ball"):
        ball_of(gait, "large", 10)


def test_a_map_says_by_which_ball_it_knows(gait, ball):
    axes = {"com_height": (1.2, 1.6), "com_speed": (0.9, 1.2)}
    by_ball, followed = (basin(gait, axes, 12, ball=of) for of in (ball, "none"))
    assert by_ball.attrs["ball"] == "tested" and by_ball.attrs["ball_points"] == 10_000
    assert 0.05 < by_ball.attrs["ball_radius"] < 1.0 and 0.8 < by_ball.attrs["ball_rate"] < 1.0
    assert followed.attrs["ball"] == "none" and "ball_radius" not in followed.attrs
    np.testing.assert_array_equal(by_ball["fate"], followed["fate"])
    assert (by_ball["strides_until_known"] == 0).any()  # starts in the ball
    assert not (followed["strides_until_known"] == 0).any()


@release
def test_a_proved_ball_is_inside_the_one_that_is_proved():
    gait = find_gait({"ground.friction": 0.6})
    proof = tdmf_slip.prove_attraction(gait)
    ball = proved_ball(gait)
    assert ball.known == "proved" and 0.1 * proof.radius < ball.radius <= proof.radius
    away = np.array(np.linalg.inv(np.array(proof.basis)) @ points_in(ball, 2000, surface=True).T).T
    assert (np.abs(away) / proof.weights).max() < proof.norm_radius
    axes = {"com_height": (0.9, 1.5), "com_speed": (0.2, 1.05)}
    slice_, followed = (basin(gait, axes, (3, 2), ball=of) for of in (ball, "none"))
    np.testing.assert_array_equal(slice_["fate"], followed["fate"])
    settled = followed["fate"].values == SETTLED
    assert settled.sum() >= 3
    more = (slice_["strides_until_known"] - followed["strides_until_known"]).values[settled]
    extents = np.linalg.norm(np.linalg.inv(ball.matrix), axis=1) / gait.runner.scales
    fewest = np.log(NEAR / extents.max()) / -np.log(gait.lambda_max)
    assert fewest > 20.0 and (more > fewest - 1.0).all()  # no runner forgets faster than by the eigenvalue
    assert slice_.attrs["ball_radius"] == pytest.approx(ball.radius)


def test_a_proved_ball_that_is_not_to_be_had_is_refused():
    with pytest.raises(InputError, match="reduced map"):
        proved_ball(find_gait({"ground.friction": 0.6}, model="reduced"))
