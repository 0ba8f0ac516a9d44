"""Rough ground: runners in the engine and runs of the unit meet the same steps; how long they stay up."""

import json
import math

import fmpy
import numpy as np
import pytest
import tdmf_slip
from fmpy.fmi3 import FMU3Slave
from tdmf_slip import Batch, InputError, Runner, find_gait, strides_to_fall
from tdmf_slip.analysis.first_passage import FirstPassage
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.ground import RoughGround

RUNNERS, STRIDES = 100, 8
GROUND = RoughGround(0.5, 5)
FELL = FATES.index("fell")


@pytest.fixture(scope="module")
def gait():
    return find_gait(Runner({"ground.friction": 0.6}))


# ---- the same steps as in the unit ---------------------------------------------------------------------


class Slave:
    """Co-Simulation of FMI 3.0 in event mode, driven from event to event."""

    def __init__(self, description, folder):
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        self.unit = FMU3Slave(
            guid=description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="rough",
        )
        self.unit.instantiate(eventModeUsed=True, earlyReturnAllowed=True)

    def set(self, name, value):
        write = self.unit.setBoolean if isinstance(value, bool) else self.unit.setFloat64
        write([self.references[name]], [value])

    def get(self, name):
        return self.unit.getFloat64([self.references[name]])[0]

    def count(self):
        return self.unit.getInt32([self.references["stride.count"]])[0]

    def fallen(self):
        return self.unit.getBoolean([self.references["status.fallen"]])[0]

    def apices(self, start, steps):
        """Time, height and speed at each, the ground stepping there once the apex is taken."""
        for name, value in start.items():
            self.set(name, value)
        self.unit.enterInitializationMode()
        self.unit.exitInitializationMode()
        self.set("ground.height", steps[0])
        self.unit.updateDiscreteStates()
        self.unit.enterStepMode()
        found, time = [], 0.0
        while len(found) < len(steps) and not self.fallen():
            *_, time = self.unit.doStep(time, 1e3)
            self.unit.enterEventMode()
            self.unit.updateDiscreteStates()
            if self.count() > len(found):
                below = self.unit.getBoolean([self.references["ground.pending"]])[0]
                found.append([self.get(f"apex.{name}") for name in ("time", "com_height", "com_speed")])
                if below:
                    break
                self.set("ground.height", steps[: len(found) + 1].sum())
                self.unit.updateDiscreteStates()
            self.unit.enterStepMode()
        self.unit.terminate()
        self.unit.freeInstance()
        return np.array(found)


def test_a_hundred_runners_meet_the_steps_that_the_unit_meets(gait, tmp_path):
    fmu = str(tdmf_slip.fmu_path(fmi=3))
    folder, description = fmpy.extract(fmu, str(tmp_path)), fmpy.read_model_description(fmu)
    batch = Batch(gait.runner, np.tile(gait.apex, (RUNNERS, 1)), GROUND, tolerance=1e-11)
    ends = [batch.run(n + 1) for n in range(STRIDES)]
    fallen = compared = 0
    for number in range(RUNNERS):
        apices = Slave(description, folder).apices(gait.start_values, GROUND.steps(number, STRIDES))
        assert len(apices) == ends[-1]["strides"][number]
        fallen += ends[-1]["fate"][number] == FELL
        for end, (time, height, speed) in zip(ends, apices, strict=False):
            found = [end.time[number], *end.apex[number, :2]]
            np.testing.assert_allclose(found, [time, height, speed], rtol=1e-7, atol=1e-7)
            compared += 1
    assert 0 < fallen < RUNNERS
    assert compared == ends[-1]["strides"].sum()


# ---- how long runners stay up ----------------------------------------------------------------------------


def test_the_interval_covers_the_mean_as_often_as_it_says():
    """Geometric numbers of strides, censored at the mean: so that a third is still up."""
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
    """Runners stopped early tell what runners tell that nearly all fall: the fall is forgetful."""
    long = strides_to_fall(gait.runner, 0.5, 400, 1, 1000)
    short = strides_to_fall(gait.runner, 0.5, 400, 2, 15)
    assert long.censored < 10 and short.censored > 100
    assert long.interval[0] < short.interval[1] and short.interval[0] < long.interval[1]


def test_a_mean_depends_on_the_seed_and_on_nobody_who_works(gait, monkeypatch):
    whole = strides_to_fall(gait.runner, 0.5, 200, 1, 30)
    assert strides_to_fall(gait.runner, 0.5, 200, 2, 30) != whole
    monkeypatch.setattr("tdmf_slip.analysis.first_passage.MAX_IN_A_BLOCK", 33)
    assert strides_to_fall(gait.runner, 0.5, 200, 1, 30) == whole


def test_the_command_tells_the_mean(command):
    status, out, _ = command(
        "rough", "--roughness", "0.5", "--runners", "64", "--seed", "3", "--max-strides", "20", "--json"
    )
    assert status == 0
    printed = json.loads(out)
    assert printed == strides_to_fall({}, 0.5, 64, 3, 20).as_json()
    assert {"mean_strides", "interval", "censored"} <= printed.keys()
    assert printed["falls"] + printed["censored"] == 64


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("--roughness -1", "--roughness = -1.0 is not allowed"),
        ("--roughness nan", "--roughness = nan is not allowed"),
        ("--roughness 0.1 --runners 0", "--runners = 0 is not allowed"),
        ("--roughness 0.1 --seed -1", "--seed = -1 is not allowed"),
        ("--roughness 0.1 --max-strides 0", "--max-strides = 0 is not allowed"),
        ("", "--roughness"),
        ("--roughness 0.5 --seed 3 --rare --runners 5", "--runners"),
    ],
)
def test_the_command_refuses_what_is_no_ground(command, arguments, message):
    status, out, said = command("rough", *arguments.split())
    assert (status, out) == (2, "")
    assert message in said


def test_rough_ground_is_of_the_full_model():
    with pytest.raises(InputError, match="reduced map"):
        strides_to_fall(Runner(model="reduced"), 0.1)
