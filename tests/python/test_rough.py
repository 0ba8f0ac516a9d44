"""Rough ground: runners in the engine and runs of the unit meet the same steps; how long they stay up."""

import math

import numpy as np
import pytest
from tdmf_slip import Batch, InputError, Runner, strides_to_fall
from tdmf_slip.analysis.first_passage import FirstPassage
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.ground import RoughGround

RUNNERS, STRIDES = 6, 6
GROUND = RoughGround(0.5, 5)
FELL = FATES.index("fell")


class Steps:
    """The heights of the ground at the apices of one run, as a law of the unit's input."""

    def __init__(self, steps):
        self.heights = iter(np.cumsum(steps))

    def inputs_at(self, _apex):
        return {"ground.height": next(self.heights)}


def test_runners_meet_the_steps_that_the_unit_meets(gait, load_example):
    """The unit is driven by FMPy from apex to apex, as in the example."""
    drive = load_example("stride_feedback").run
    batch = Batch(gait.runner, np.tile(gait.apex, (RUNNERS, 1)), GROUND, tolerance=1e-11)
    run, fallen = batch.run(STRIDES, record=True), 0
    for number in range(RUNNERS):
        law = Steps(GROUND.steps(number, STRIDES))
        apices, _ = drive(law, gait.start_values, strides=STRIDES)
        made, fell = run["strides"][number], run["fate"][number] == FELL
        assert (
            len(apices) == made + 1 or fell
        )  # in the engine a foot below the ground for a stride falls, too
        found = run.recorded["next_apex"][number, :made]
        np.testing.assert_allclose(found, apices[1 : made + 1], rtol=1e-6, atol=1e-6)
        fallen += fell
    assert 0 < fallen < RUNNERS


def test_the_interval_covers_the_mean_as_often_as_it_says():
    """Geometric numbers of strides, censored at the mean, where a third is still up."""
    mean, runners, experiments = 40, 12, 2000
    lengths = np.random.default_rng(3).geometric(1.0 / mean, size=(experiments, runners))
    runner, covered = Runner(), 0
    for row in lengths:
        falls = int((row <= mean).sum())
        low, high = FirstPassage(runner, "", 0.1, runners, falls, int(np.minimum(row, mean).sum())).interval
        covered += low < mean < high
    assert covered / experiments == pytest.approx(0.95, abs=0.02)


def test_where_none_falls_the_mean_is_open_above_and_where_all_fall_at_once_it_is_one():
    found = FirstPassage(Runner(), "", 0.1, 10, 0, 1000)
    low, high = found.interval
    assert found.mean_strides == high == math.inf
    assert 1000 * math.log1p(-1.0 / low) == pytest.approx(-0.5 * 1.959963984540054**2)
    assert found.censored == 10
    found = FirstPassage(Runner(), "", 9.0, 10, 10, 10)
    assert found.mean_strides == found.interval[0] == 1.0
    assert found.interval[1] > 1.0


def test_censoring_does_not_move_the_mean(gait):
    """Runners stopped early have the same mean as runners that nearly all fall: the fall is memoryless."""
    long = strides_to_fall(gait.runner, 0.5, 400, 1, 1000)
    short = strides_to_fall(gait.runner, 0.5, 400, 2, 15)
    assert long.censored < 10 and short.censored > 100
    assert long.interval[0] < short.interval[1] and short.interval[0] < long.interval[1]


def test_a_mean_depends_on_the_seed(gait):
    whole = strides_to_fall(gait.runner, 0.5, 200, 1, 30)
    assert strides_to_fall(gait.runner, 0.5, 200, 2, 30) != whole
    assert f", {whole.falls} of 200 runners fell>" in repr(whole)


@pytest.mark.parametrize("way", [("--runners", 20), ("--rare",)], ids=["plain", "rare"])
def test_the_command_draws_how_many_are_still_up(command, tmp_path, way):
    pytest.importorskip("matplotlib")
    status, out, _ = command("rough", "--roughness", 0.5, *way, "--plot", "falls.png")
    assert status == 0 and "mean_strides" in out
    assert (tmp_path / "falls.png").read_bytes().startswith(b"\x89PNG")


def test_the_command_prints_the_mean(command):
    options = ("--roughness", "0.5", "--runners", "64", "--seed", "3", "--max-strides", "20")
    printed = command.json("rough", *options)
    assert printed == strides_to_fall({}, 0.5, 64, 3, 20).as_json()
    assert {"mean_strides", "interval", "censored"} <= printed.keys()
    assert printed["falls"] + printed["censored"] == 64


def test_rough_ground_is_of_the_full_model():
    with pytest.raises(InputError, match="reduced map"):
        strides_to_fall(Runner(model="reduced"), 0.1)


@pytest.mark.parametrize("foot_x", ["randm", [0.0, 1.0], float("nan")])
def test_feet_are_numbers_or_random(gait, foot_x):
    with pytest.raises(InputError, match="foot"):
        strides_to_fall(gait.runner, 0.1, 3, foot_x=foot_x)
