"""A runner is an immutable mapping over the table of variables, and the table is the unit's."""

import copy
import dataclasses
import pickle
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest
import tdmf_slip
from tdmf_slip import InputError, Runner, find_gait
from tdmf_slip.library.members import FLAGS, MOVING
from tdmf_slip.variables.parameters import preset_names
from tdmf_slip.variables.table import DIMENSIONS, MODELS, STATES, VARIABLES

FRICTION = "ground.friction"


@pytest.mark.parametrize("fmi", [2, 3])
def test_the_table_is_that_of_the_unit(fmi):
    unit = tdmf_slip.load_fmu(tdmf_slip.fmu_path(fmi)).variables
    assert list(VARIABLES) == list(unit) and len(unit) > 130
    for name, variable in VARIABLES.items():
        types = {"Float64": "Real", "Int32": "Integer"}
        own = dataclasses.replace(unit[name], type=types.get(unit[name].type, unit[name].type))
        assert variable == own, name


def test_every_unit_and_coordinate_of_the_table_is_known():
    assert {variable.unit or "1" for variable in VARIABLES.values()} <= set(DIMENSIONS)
    for model in MODELS.values():
        assert {quantity.unit for quantity in model.quantities.values()} <= set(DIMENSIONS)
        assert all(f"apex.{name}" in VARIABLES for name in model.coordinates)
        coordinates = {quantity.coordinate for quantity in model.quantities.values()} - {""}
        assert coordinates <= set(model.coordinates) and len(coordinates) >= 2


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_a_gait_has_the_quantities_that_its_model_has(model):
    gait = find_gait(model=model)
    known = MODELS[model].quantities
    assert set(gait.stride) <= set(known)
    missing = set(known) - set(gait.stride) - {"frequency", "liftoff_angle"}
    assert {known[name].coordinate for name in missing} <= set(gait.runner.coordinates)


def test_a_runner_is_a_mapping_of_all_values():
    runner = Runner(friction=0.43, damping="0.25 N.s/m")
    assert set(runner) == {*MOVING, *STATES} and len(runner) == len(list(runner))
    assert runner[FRICTION] == runner["friction"] == runner.get("friction") == 0.43
    assert runner["leg.damping"] == 0.25 and "leg.damping" in runner and "damping" in runner
    assert "nosuch" not in runner and 3 not in runner and runner.get("nosuch") is None
    assert all(isinstance(runner[name], bool) for name in FLAGS)
    with pytest.raises(KeyError, match=r"dampin.*near matches: .*damping"):
        runner["dampin"]


def test_replace_makes_another_runner():
    runner = Runner()
    other = runner.replace(friction=0.2, **{"leg.damping": 0.02})
    assert (other[FRICTION], other["leg.damping"], runner[FRICTION]) == (0.2, 0.02, 0.6)
    assert {name for name in runner if runner[name] != other[name]} == {FRICTION, "leg.damping"}
    assert runner.replace() is runner.replace(friction=0.6) is Runner(runner) is runner
    assert other.replace({"damping": 0.2, FRICTION: 0.6}) == runner


def test_values_that_go_together_are_replaced_together():
    """Whatever their order, and though one of them alone is refused."""
    runner, grown = Runner(), {"leg.min_length": 1.5, "leg.free_length": 2.0}
    assert runner.replace(grown) == runner.replace(dict(reversed(grown.items())))
    with pytest.raises(InputError, match="min_length"):
        runner.replace(min_length=1.5)


def test_runners_are_equal_and_hashed_by_value():
    runner, again = Runner(friction=0.43), Runner({FRICTION: 0.43})
    assert runner == again and hash(runner) == hash(again) and len({runner, again}) == 1
    others = [
        runner.replace(friction=0.4300001),
        Runner(runner, model="reduced"),
        Runner(runner, tolerance=1e-9),
    ]
    assert len({runner, *others}) == 4 and all(runner != other for other in others)
    assert (runner == dict(runner)) is False and (runner == np.zeros(3)) is False and runner != None  # noqa: E711


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_copies_are_equal_and_work_alike(model):
    runner = Runner("human", model=model, tolerance=1e-12)
    runner.scales.sum()
    for other in (pickle.loads(pickle.dumps(runner)), copy.copy(runner), copy.deepcopy(runner)):
        assert other == runner and (other.model, other.tolerance) == (runner.model, 1e-12)
        assert np.array_equal(other.start_apex(), runner.start_apex())
    with ProcessPoolExecutor(1) as pool:
        assert pool.submit(Runner, runner).result(60) == runner


def test_a_runner_cannot_change():
    runner = Runner()
    with pytest.raises(TypeError):
        runner[FRICTION] = 0.2
    for name in ("model", "tolerance", "_values", "new"):
        with pytest.raises(AttributeError, match=f"replace\\({name}="):
            setattr(runner, name, 1)
    with pytest.raises(AttributeError):
        del runner.model
    for array in (runner.scales, runner.parameters, runner.inputs):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_every_preset_is_found_by_name_and_by_file_name(tmp_path, monkeypatch, command):
    monkeypatch.chdir(tmp_path)
    assert {"human", "human_running", "paper"} <= set(preset_names())
    for name in preset_names():
        assert Runner(name) == Runner(f"{name}.toml")
        status, out, err = command("gait", "--model", "reduced", "--parameters", f"{name}.toml", "--json")
        assert status == 0 and out, err
    (tmp_path / "human.toml").write_text("friction = 0.5\n", encoding="utf-8")
    assert Runner("human.toml")[FRICTION] == 0.5 != Runner("human")[FRICTION]


@pytest.mark.parametrize(
    ("values", "match"),
    [
        ({"leg.damping": -0.1}, r"leg\.damping = -0\.1 is not allowed; allowed: 0 to"),
        ({"friction": float("nan")}, r"ground\.friction = nan is not allowed"),
        ({"friction": "0.5 kg"}, "unknown unit 'kg'"),
        ({"stride.period": 1.0}, "takes no start value"),
        ({"nosuch": 1.0}, "no variable 'nosuch'"),
        ({"leg.min_length": 2.0}, r"leg\.(min|free)_length"),
    ],
)
def test_values_are_checked_when_a_runner_is_made(values, match):
    """Alone and beside each other."""
    with pytest.raises(InputError, match=match):
        Runner(values)
    if "stride.period" not in values and "nosuch" not in values:
        with pytest.raises(InputError, match=match):
            Runner().replace(values)
