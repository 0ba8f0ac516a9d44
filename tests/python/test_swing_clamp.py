"""The two readings of (12), with the clamp max{..., 0} and without it, from Python and the command."""

import json

import numpy as np
import pytest
import xarray
from conftest import reference_gaits
from scipy_strides import Stride
from tdmf_slip import Batch, InputError, Runner, find_gait, stride_map
from tdmf_slip.record import runner_in

CLAMP = "hip.swing_clamp"
FREE = {gait["friction"]: gait for gait in reference_gaits(False)}


@pytest.mark.parametrize("clamp", [False, True])
@pytest.mark.parametrize("friction", FREE)
def test_a_stride_is_that_of_scipy_for_two_point_masses(friction, clamp):
    gait = find_gait({"ground.friction": friction, CLAMP: clamp})
    start = gait.apex + np.array([0.01, 0.01, 0.0, 0.02, 0.01, -0.02])
    other = Stride(friction, clamp).run(start)
    found = stride_map(gait.runner, start)
    assert other["word"] == found["word"].item()
    assert np.abs(other["apex"] - found["next_apex"].values[0, 0]).max() < 1e-8
    for name in ("period", "length", "work"):
        assert other[name] == pytest.approx(found[name].item(), abs=1e-8), name


# ---- where it is set ---------------------------------------------------------------------------------------


def test_files_options_and_mappings_set_it(command, tmp_path):
    toml, table = tmp_path / "clamped.toml", tmp_path / "clamped.json"
    toml.write_text("[hip]\nswing_clamp = true\n", encoding="utf-8")
    table.write_text(json.dumps({CLAMP: True}), encoding="utf-8")
    (expected,) = (gait["speed"] for gait in reference_gaits(True) if gait["friction"] == 0.6)
    for given in (["--parameters", toml], ["--parameters", table], ["--set", f"{CLAMP}=true"]):
        plain = command.json("gait", *given)
        assert plain["speed"] == pytest.approx(expected, abs=1e-11) and plain["start_values"][CLAMP] is True
    free = find_gait("human")
    clamped = find_gait(Runner("human").replace({CLAMP: True}))
    assert clamped.speed != pytest.approx(free.speed, rel=1e-4)
    assert find_gait(clamped.runner.replace({CLAMP: False})).apex == pytest.approx(free.apex, abs=1e-9)


def test_the_unit_runs_without_the_clamp_from_the_gait_s_file(command, tmp_path):
    reference, file, rows = FREE[0.6], tmp_path / "gait.json", tmp_path / "run.nc"
    file.write_text(command("gait", "--set", f"{CLAMP}=0", "--json")[1], encoding="utf-8")
    options = ("--strides", 1, "--output", rows, "--tolerance", 1e-12)
    run = command.json("simulate", "--from-gait", file, *options)
    assert run["stride"]["word"] == reference["word"] and run["start_values"][CLAMP] is False
    assert run["stride"]["speed"] == pytest.approx(reference["speed"], abs=1e-8)
    assert runner_in(xarray.load_dataset(rows))[CLAMP] is False


def test_runners_of_both_readings_run_in_one_ensemble():
    clamps, friction = [True, False, False, True], [0.6, 0.6, 0.2, 0.2]
    runners = [Runner({"ground.friction": mu, CLAMP: of}) for mu, of in zip(friction, clamps, strict=True)]
    apices = np.array([find_gait(runner).apex for runner in runners]) + 0.01
    found = stride_map({"ground.friction": friction, CLAMP: clamps}, apices, strides=3)
    for number, runner in enumerate(runners):
        alone = stride_map(runner, apices[number], strides=3)
        np.testing.assert_allclose(
            found["next_apex"].values[number], alone["next_apex"].values[0], atol=1e-12
        )
        assert (found["word"].values[number] == alone["word"].values[0]).all()
    assert found[CLAMP].values.tolist() == clamps and CLAMP not in runner_in(found)
    ends = Batch(runners, apices).run(3)
    np.testing.assert_allclose(ends["apex"], found["next_apex"].values[:, -1], atol=1e-7)


@pytest.mark.parametrize("value", [False, 0, 0.0, "0", "false", np.False_])
def test_a_runner_records_it_as_a_boolean_however_it_was_given(value):
    given = Runner({CLAMP: True})
    changed = Runner(given, swing_clamp=value), given.replace({CLAMP: value}), Runner({**given, CLAMP: value})
    assert all(runner.record()["runner"][CLAMP] is False for runner in changed)


def test_what_is_neither_true_nor_false_is_refused():
    with pytest.raises(InputError, match=f"runner 1: {CLAMP} = 0.5 is not allowed; allowed: true or false"):
        stride_map({CLAMP: [1.0, 0.5]}, Runner().apex())
    with pytest.raises(InputError, match=f"{CLAMP} = 0.5 is not allowed; allowed: true or false"):
        Runner().replace({CLAMP: 0.5})
    with pytest.raises(InputError, match=f"{CLAMP} = nan is not allowed; allowed: true or false"):
        Runner({**Runner(), CLAMP: np.nan})


def test_the_reduced_map_does_not_depend_on_it_and_says_so(command):
    gaits = [find_gait({CLAMP: clamp}, model="reduced") for clamp in (True, False)]
    assert np.array_equal(gaits[0].apex, gaits[1].apex)
    status, out, err = command("gait", "--model", "reduced", "--set", f"{CLAMP}=false", "--json")
    assert status == 0 and json.loads(out)["model"] == "reduced"
    assert err == f"tdmf-slip: warning: --set {CLAMP}: has no effect in the reduced map\n"
