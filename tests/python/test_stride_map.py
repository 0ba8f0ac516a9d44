"""The stride map of many runners: settings by stride, by a function and by the engine's law; what is kept."""

import re

import numpy as np
import pytest
import xarray
from tdmf_slip import AffineLaw, InputError, RunError, Runner, find_gait, stride_map
from tdmf_slip.analysis import stride_map as module
from tdmf_slip.blocks import InTurn
from tdmf_slip.library.batch_tables import STRIDE_FATES
from tdmf_slip.library.binding import c
from tdmf_slip.library.engine import instruction_sets
from tdmf_slip.library.gait import LEDGER
from tdmf_slip.library.quantities import STRIDE_QUANTITIES
from tdmf_slip.library.settings import SETTINGS
from tdmf_slip.library.strides import strides_from
from tdmf_slip.record import runner_in

RUNNERS, STRIDES = 30, 6
ANGLE, TORQUE = "hip.touchdown_angle", "hip.stance_torque"
NAMES = (ANGLE, TORQUE)
CLOSED, FELL = STRIDE_FATES.index("closed"), STRIDE_FATES.index("fell")


@pytest.fixture(scope="module")
def starts(gait):
    return gait.apex + np.random.default_rng(1).uniform(-0.05, 0.05, (RUNNERS, 6))


def law_of(gait, noise=None, seed=4):
    gain = np.random.default_rng(2).uniform(-0.3, 0.3, (2, 6)) * [[1.0], [0.1]]
    nominal = np.array([gait.runner[name] for name in NAMES])
    return AffineLaw(NAMES, gait.apex, nominal, gain, nominal - 0.01, nominal + 0.01, noise, seed)


def function_of(law, noise=lambda stride: 0.0):
    """The same with NumPy, in the order of the engine's sum."""
    calls = []

    def function(apices, stride_number):
        deviation = apices + noise(len(calls)) - np.array(law.apex)
        calls.append(len(apices))
        values = {}
        for name, nominal, gain, low, high in zip(
            law.inputs, law.nominal, law.gain, law.low, law.high, strict=True
        ):
            value = np.full(len(apices), nominal)
            for j in range(6):
                value = value + gain[j] * deviation[:, j]
            values[name] = np.clip(value, low, high)
        return values

    function.calls = calls
    return function


def assert_same(one, other):
    """Bit for bit, in all that is kept."""
    assert set(one.data_vars) == set(other.data_vars)
    for name in one.data_vars:
        np.testing.assert_array_equal(one[name], other[name], err_msg=name)


def one_stride(found, runner, stride):
    """Quantities of one stride, by name."""
    return {name: found[name][runner, stride] for name in found.data_vars if found[name].ndim > 1}


# ---- what is kept -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("instructions", instruction_sets())
def test_each_stride_is_that_of_the_return_map(gait, starts, instructions):
    """A runner with a torque of its own in coast, whose power changes its sign."""
    runner = gait.runner.replace({"hip.external_torque": 0.01})
    found = stride_map(runner, starts, strides=2, tolerance=1e-13, instructions=instructions)
    compared = 0
    for number, start in enumerate(starts[:10]):
        for stride in (0, 1):
            here = one_stride(found, number, stride)
            assert here["fate"] == CLOSED
            stride = strides_from(runner, here["apex"])
            for name in (*STRIDE_QUANTITIES, *LEDGER):
                assert here[name] == pytest.approx(stride.stride[name], abs=1e-8), name
            assert here["word"] == stride.word
            assert here["liftoff_angle"] == pytest.approx(stride.liftoff_angle, abs=1e-9)
            np.testing.assert_allclose(here["next_apex"] - here["apex"], stride.residual, atol=1e-9)
            compared += 1
        np.testing.assert_array_equal(found["apex"][number, 0], start)
    np.testing.assert_array_equal(found["apex"][:, 1], found["next_apex"][:, 0])
    assert compared == 20


def test_a_runner_below_its_ground_for_a_whole_stride_has_fallen_and_the_rule_is_told(gait):
    """A ground of 2 m is never in force: the stride below it closes as on the one before; it is the last."""
    found = stride_map(gait.runner, gait.apex, strides=4, inputs={"ground.height": [0.0, 2.0, 0.0, 0.0]})
    assert [STRIDE_FATES[fate] for fate in found["fate"].values[0]] == ["closed", "closed", "fell", "fell"]
    np.testing.assert_allclose(found["period"][0, :2], gait.period, rtol=1e-9)
    low = stride_map(gait.runner, gait.apex, strides=4, inputs={"ground.height": [0.0, 0.2, 0.2, 0.2]})
    assert (low["fate"] == CLOSED).all()
    assert "below a new ground for a whole stride" in found["fate"].attrs["comment"]
    assert "below its ground for a whole stride has fallen" in " ".join(stride_map.__doc__.split())


def test_after_a_fall_there_is_nothing_but_the_fate(gait):
    low = gait.apex * [0.75, 1.0, 1.0, 1.0, 1.0, 1.0]
    below = gait.apex * [0.1, 1.0, 1.0, 1.0, 1.0, 1.0]
    angle = gait.runner[ANGLE]
    found = stride_map(
        gait.runner,
        [gait.apex, gait.apex, low, below],
        strides=4,
        inputs={ANGLE: [[angle] * 4, [angle, -0.5, angle, angle], [angle] * 4, [angle] * 4]},
    )
    fates = [[STRIDE_FATES[fate] for fate in row] for row in found["fate"].values]
    assert fates[0] == ["closed"] * 4
    assert fates[1] == ["closed", "fell", "fell", "fell"]
    assert fates[3] == ["no_start"] * 4
    closed = found["fate"] == CLOSED
    for name in (*STRIDE_QUANTITIES, *LEDGER, "liftoff_angle", "next_apex"):
        kept = np.isfinite(found[name])
        np.testing.assert_array_equal(kept if kept.ndim == 2 else kept.all(axis=-1), closed, err_msg=name)
    np.testing.assert_array_equal(found["word"] != "", closed)
    np.testing.assert_array_equal(found[ANGLE][1], [angle, -0.5, np.nan, np.nan])
    assert np.isnan(found[ANGLE][3]).all()
    assert np.isfinite(found["apex"][1, :2]).all() and np.isnan(found["apex"][1, 2:]).all()


def test_the_dataset_goes_through_a_file_and_back(gait, starts, tmp_path):
    made = stride_map(gait.runner, starts, strides=2, roughness=0.3, seed=2**63)
    made.to_netcdf(tmp_path / "strides.nc")
    with xarray.open_dataset(tmp_path / "strides.nc") as found:
        xarray.testing.assert_equal(found.load(), made)
        assert found.attrs["seed"] == str(2**63)
        assert found["speed"].attrs["units"] == "m/s"
        assert found["fate"].attrs["flag_meanings"].split() == list(STRIDE_FATES)


# ---- settings ---------------------------------------------------------------------------------------------


def test_runners_have_their_own_parameters_and_settings(gait, starts):
    rng = np.random.default_rng(3)
    stiffness, friction = rng.uniform(0.9, 1.1, RUNNERS), rng.uniform(0.4, 0.8, RUNNERS)
    angle, torque = rng.uniform(0.69, 0.71, (RUNNERS, 2)), rng.uniform(0.195, 0.205, 2)
    found = stride_map(
        {"foot.mass": 0.11, "leg.stiffness": stiffness, "ground.friction": friction},
        (gait.apex + starts) / 2,
        strides=2,
        inputs={ANGLE: angle, TORQUE: torque, "hip.kd": 0.5},
        tolerance=1e-13,
    )
    compared = 0
    for number in range(RUNNERS):
        for stride in (0, 1):
            values = {
                "foot.mass": 0.11,
                "leg.stiffness": stiffness[number],
                "ground.friction": friction[number],
                ANGLE: angle[number, stride],
                TORQUE: torque[stride],
                "hip.kd": 0.5,
            }
            runner, here = Runner(values), one_stride(found, number, stride)
            if here["fate"] == FELL:
                with pytest.raises(RunError, match="fell"):
                    strides_from(runner, here["apex"])
                continue
            stride = strides_from(runner, here["apex"])
            assert here["word"] == stride.word
            assert here["cost_of_transport"] == pytest.approx(stride.stride["cost_of_transport"], abs=1e-8)
            np.testing.assert_allclose(here["next_apex"] - here["apex"], stride.residual, atol=1e-8)
            compared += 1
    assert RUNNERS < compared < 2 * RUNNERS
    np.testing.assert_array_equal(found[TORQUE], np.tile(torque, (RUNNERS, 1)))
    np.testing.assert_array_equal(found["leg.stiffness"], stiffness)
    assert "leg.stiffness" not in runner_in(found) and runner_in(found)["foot.mass"] == 0.11


def test_every_setting_may_change_and_acts(gait):
    """Settings change from the second stride on. The first runs on the whole page, which rounds otherwise."""
    usual = gait.runner
    as_ever = stride_map(gait.runner, gait.apex, strides=2)
    for name in SETTINGS:
        change = 1e-3 if name.startswith(("leg", "hip", "control")) else 1e-4
        settings = {name: [usual[name], usual[name] + change]}
        found = stride_map(gait.runner, gait.apex, strides=2, inputs=settings)
        first, as_usual = found["next_apex"][:, 0], as_ever["next_apex"][:, 0]
        np.testing.assert_allclose(first, as_usual, rtol=0, atol=1e-12, err_msg=name)
        moved = (
            np.abs(found["next_apex"] - as_ever["next_apex"])[:, 1].max() if name != "ground.height" else 1
        )
        assert found["fate"][0, 1] == CLOSED and moved > 1e-7, name


# ---- laws -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("instructions", instruction_sets())
@pytest.mark.parametrize("roughness", [0.0, 0.6])
def test_the_law_of_the_engine_is_the_function_that_does_the_same(gait, starts, roughness, instructions):
    law = law_of(gait)
    function = function_of(law)
    how = {"strides": STRIDES, "roughness": roughness, "seed": 3, "instructions": instructions}
    found = stride_map(gait.runner, starts, law=law, **how)
    assert_same(stride_map(gait.runner, starts, law=function, **how), found)
    assert function.calls == [RUNNERS] * STRIDES
    settings = np.array([found[name] for name in NAMES])
    at_limits = settings == np.array(law.low)[:, None, None]
    assert at_limits.any() and not at_limits.all()
    fell = (found["fate"] == FELL).any()
    assert fell == (roughness > 0.0)


def test_one_law_sets_while_another_is_given(gait, starts):
    friction = np.random.default_rng(5).uniform(0.5, 0.7, (RUNNERS, STRIDES))
    law = law_of(gait)
    how = {"strides": STRIDES, "inputs": {"ground.friction": friction}}
    found = stride_map(gait.runner, starts, law=law, **how)
    assert_same(stride_map(gait.runner, starts, law=function_of(law), **how), found)
    np.testing.assert_array_equal(found["ground.friction"], friction)


def test_a_run_depends_on_its_number_and_not_on_who_works(gait, starts, monkeypatch):
    law = law_of(gait, noise=[0.01] * 6)
    how = {"strides": STRIDES, "law": law, "roughness": 0.1}
    whole = stride_map(gait.runner, starts, **how)
    part = stride_map(gait.runner, starts[7:19], first_number=7, **how)
    for name in part.data_vars:
        np.testing.assert_array_equal(part[name], whole[name][7:19], err_msg=name)
    np.testing.assert_array_equal(part["runner"], np.arange(7, 19))
    monkeypatch.setattr("tdmf_slip.terminal.in_blocks.MIN_RUNNERS", 11)
    monkeypatch.setattr(module, "STRIDES_IN_A_BLOCK", 11 * STRIDES)
    assert_same(stride_map(gait.runner, starts, **how), whole)


# ---- noise ------------------------------------------------------------------------------------------------


def test_ground_friction_sensors_strides_runners_and_seeds_have_deviates_of_their_own():
    """A seed and a number of a runner also count beyond 32 bits."""
    seed, runner = 2**40 + 5, 2**33
    drawn = [of(seed, runner, 1) for of in (c.tdmf_ground_step, c.tdmf_friction_deviate)]
    drawn += [c.tdmf_sensor_noise(seed, runner, 1, coordinate) for coordinate in range(8)]
    others = (seed, runner, 2), (seed, runner + 1, 1), (seed, 0, 1), (5, runner, 1)
    drawn += [c.tdmf_sensor_noise(*other, 0) for other in others]
    assert len(set(drawn)) == 14


def test_noise_is_that_of_each_sensor_runner_and_stride(gait, starts):
    """The C tests compare its generator with published numbers and with the normal distribution."""
    deviations, seed = np.array([0.01, 0.02, 0.0, 0.03, 0.0, 0.01]), 2**40 + 5
    first = 2**33

    def noise(stride):
        return [
            [deviation * c.tdmf_sensor_noise(seed, n, stride, j) for j, deviation in enumerate(deviations)]
            for n in range(first, first + RUNNERS)
        ]

    law = law_of(gait, deviations, seed)
    assert law.is_noisy
    how = {"strides": 3, "first_number": first}
    found = stride_map(gait.runner, starts, law=law, **how)
    assert_same(stride_map(gait.runner, starts, law=function_of(law, noise), **how), found)
    other = stride_map(gait.runner, starts, law=law_of(gait, deviations, seed + 1), **how)
    assert not np.array_equal(other[ANGLE], found[ANGLE])
    inputs = law.inputs_at(starts[2], runner=first + 2)
    assert inputs == {name: found[name][2, 0] for name in NAMES}


# ---- the reduced map --------------------------------------------------------------------------------------


def test_the_reduced_map_has_laws_too():
    gait = find_gait({"ground.friction": 0.6}, model="reduced")
    starts = gait.apex + np.random.default_rng(6).uniform(-0.03, 0.03, (RUNNERS, 2))
    nominal = gait.runner[ANGLE]
    law = AffineLaw([ANGLE], gait.apex, [nominal], [[0.2, -0.1]], [nominal - 0.004], [nominal + 0.004])

    def function(apices, stride_number):
        deviation = apices - np.array(law.apex)
        value = (nominal + law.gain[0][0] * deviation[:, 0]) + law.gain[0][1] * deviation[:, 1]
        return {ANGLE: np.clip(value, law.low[0], law.high[0])}

    found = stride_map(gait.runner, starts, strides=3, law=law)
    assert_same(stride_map(gait.runner, starts, strides=3, law=function), found)
    assert found["apex"].shape == (RUNNERS, 3, 2) and found.attrs["model"] == "reduced"
    compared = 0
    for number in range(RUNNERS):
        here = one_stride(found, number, 1)
        stride = strides_from(gait.runner.replace({ANGLE: float(here[ANGLE])}), here["apex"])
        np.testing.assert_allclose(here["next_apex"] - here["apex"], stride.residual, atol=1e-8)
        for name in STRIDE_QUANTITIES:
            assert here[name] == pytest.approx(stride.stride[name], abs=1e-7), name
        compared += 1
    assert compared == RUNNERS


# ---- what is refused --------------------------------------------------------------------------------------


def gives(value, at, runner):
    """A law that sets a value for one runner from a stride on."""

    def law(apices, stride_number):
        angles = np.full(len(apices), 0.7)
        if stride_number >= at:
            angles[runner] = value
        return {ANGLE: angles}

    return law


ALLOWED = "is not allowed; allowed: -1.5708 to 1.5708 rad"
HELD = AffineLaw([ANGLE], [0] * 6, [0.7], [[0] * 6], [0.1], [1])
PATCH = {"ground.patch_begin": 1.0, "ground.patch_end": 2.0}
REFUSED = {
    "inputs: leg.stiffness cannot change in a run; allowed: hip.stance_torque, hip": {
        "inputs": {"leg.stiffness": 1}
    },
    "inputs: 'hip.angle' is not a setting; near matches: ": {"inputs": {"hip.angle": 1}},
    "inputs: hip.kp of shape (2,); allowed: a number, (3,) or (runners, 3)": {"inputs": {"hip.kp": [1, 2]}},
    "inputs: runner 0, stride 1: ground.friction = -0.5": {"inputs": {"ground.friction": [1, -0.5, 1]}},
    "inputs: runner 0, stride 2: hip.kp = nan is not allowed": {"inputs": {"hip.kp": [1, 1, np.nan]}},
    "inputs: hip.kp = 'much' is not allowed": {"inputs": {"hip.kp": "much"}},
    "inputs: hip.touchdown_angle has no effect if hip.kp and hip.kd are 0": {
        "runner": {"hip.kp": 0.0, "hip.kd": 0.0},
        "inputs": {ANGLE: 0.6},
    },
    "inputs: hip.kp has no effect in the reduced map": {
        "model": "reduced",
        "apices": [1.4, 1.05],
        "inputs": {"hip.kp": 1.0},
    },
    f"law: stride 1: runner 4: hip.touchdown_angle = nan {ALLOWED}": {"law": gives(np.nan, 1, 4)},
    f"law: stride 2: runner 0: hip.touchdown_angle = 2 {ALLOWED}": {"law": gives(2.0, 2, 0)},
    "law: stride 0: hip.kp of shape (2,); allowed: (30,), or one for all": {
        "law": lambda *_: {"hip.kp": [1, 2]}
    },
    "law: gravity cannot change in a run": {"law": lambda *_: {"gravity": 1}},
    "law: stride 0: what it gives = 3 is not allowed; allowed: numbers or arrays": {"law": lambda *_: 3},
    "law = 3 is not allowed; allowed: a function of apices and the number of the stride, or an Aff": {
        "law": 3
    },
    "law: hip.kp is in the inputs, too": {"law": lambda *_: {"hip.kp": 1}, "inputs": {"hip.kp": 1}},
    "law: hip.touchdown_angle is in the inputs, too": {"law": HELD, "inputs": {ANGLE: 0.7}},
    "law: ground.height on rough ground": {"law": lambda *_: {"ground.height": 0}, "roughness": 0.1},
    "executor: the law is a function": {"law": lambda *_: {}, "executor": InTurn()},
    "runner's values of 4 runners, apices of 30": {"runner": {"leg.damping": np.full(4, 0.2)}},
    "runner: runner 2: leg.damping = -1": {"runner": {"leg.damping": [0.2] * 2 + [-1] * 28}},
    "apices of shape (2, 5); allowed: rows of com_height": {"apices": np.ones((2, 5))},
    "strides = 0 is not allowed": {"strides": 0},
    "instructions 'fast': allowed here": {"instructions": "fast"},
    "derivatives: the ground steps at the apices": {"roughness": 0.1, "derivatives": ["gravity"]},
    "derivatives: 'friktion' is not allowed": {"derivatives": ["friktion"]},
    "is given twice; allowed: once": {"derivatives": ["friction", "ground.friction"]},
    "without derivatives": {"runner": PATCH, "derivatives": ["friction"]},
}


@pytest.mark.parametrize("message", REFUSED)
def test_wrong_strides_are_refused_with_the_allowed_ones(gait, starts, message):
    given = {"runner": gait.runner, "apices": starts, "strides": 3} | REFUSED[message]
    with pytest.raises(InputError, match=re.escape(message)):
        stride_map(**given)


def test_strides_over_a_patch_by_gains_that_are_set_and_of_no_runner_are_made(gait):
    assert stride_map(PATCH, gait.apex)["fate"].shape == (1, 1)
    assert (
        stride_map({"hip.kp": 0.0, "hip.kd": 0.0}, gait.apex, inputs={ANGLE: 0.6, "hip.kp": 1.0}).sizes[
            "runner"
        ]
        == 1
    )
    assert stride_map(gait, np.zeros((0, 6)), strides=2)["next_apex"].shape == (0, 2, 6)


def test_settings_of_a_fallen_runner_do_not_matter(gait, starts):
    found = stride_map(
        gait.runner,
        starts,
        strides=STRIDES,
        law=lambda apices, stride_number: {ANGLE: np.where(np.isnan(apices[:, 0]), np.nan, 0.698)},
        roughness=0.6,
    )
    fell = (found["fate"] == FELL)[:, -1]
    assert fell.any() and not fell.all()


def test_an_affine_law_is_checked_when_it_is_made(gait):
    def refused(message, **changed):
        given = {
            "inputs": ["hip.kp"],
            "apex": gait.apex,
            "nominal": [1],
            "gain": [[0] * 6],
            "low": [0],
            "high": [2],
        }
        with pytest.raises(InputError, match=re.escape(message)):
            AffineLaw(**(given | changed))

    refused("inputs: leg.damping cannot change in a run", inputs=["leg.damping"])
    refused("inputs = 'hip.kp' is not allowed; allowed: one or more names in a list", inputs="hip.kp")
    refused("gain of shape (1, 5): allowed: (1, 6)", gain=[[0] * 5])
    refused("gain = [[nan, nan, nan, nan, nan, nan]] is not allowed", gain=[[np.nan] * 6])
    refused("high = [nan] is not allowed", high=[np.nan])
    refused("low: hip.kp = -1 is not allowed", low=[-1])
    refused("low: hip.kp = 3 is not allowed; allowed: up to high = 2", low=[3])
    refused(
        "noise = [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0] is not allowed; allowed: 0 or above", noise=[-1] + [0] * 5
    )
    refused("seed = -1 is not allowed", seed=-1)
    twice = {"nominal": [1, 1], "gain": [[0] * 6] * 2, "low": [0, 0], "high": [2, 2]}
    refused("inputs: hip.kp is there twice", inputs=["hip.kp", "hip.kp"], **twice)


# ---- derivatives -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_derivatives_are_those_of_differences_with_the_settings_of_each_stride(gait, model):
    """Runners differ, and have a law and inputs. Strides that do not close have no derivatives."""
    size = 6 if model == "full" else 2
    apices = [gait.apex[:size], gait.apex[:size] * ([1.05] + [1.0] * (size - 1)), [0.3] + [1.0] * (size - 1)]
    names = ["leg.stiffness", ANGLE, "gravity"]
    how = {"strides": 2, "model": model, "tolerance": 1e-13, "instructions": "one by one"}
    runner = {"leg.damping": [0.19, 0.2, 0.2]}

    def law(apices, stride_number):
        return {ANGLE: 0.69 + 0.02 * stride_number + 0.0 * apices[:, 0]}

    inputs = {TORQUE: [[0.2, 0.19], [0.21, 0.2], [0.2, 0.2]]}
    found = stride_map(runner, apices, law=law, inputs=inputs, derivatives=names, **how)
    assert found["next_apex_by"].dims == ("runner", "stride", "coordinate", "by")
    assert found["by"].values.tolist() == [*found["coordinate"].values, *names]
    assert np.isnan(found["next_apex_by"][2]).all() and np.isnan(found["speed_by"][2]).all()
    for number in (0, 1):
        for stride in (0, 1):
            at = {ANGLE: 0.69 + 0.02 * stride, TORQUE: inputs[TORQUE][number][stride]}
            base = Runner({"leg.damping": runner["leg.damping"][number], **at}, model=model)
            apex = found["apex"].values[number, stride]

            def moved(name, h, base=base, apex=apex):
                if name in base:
                    return stride_map(base.replace({name: base[name] + h}), apex, **how)
                step = h * np.eye(size)[list(found["coordinate"].values).index(name)]
                return stride_map(base, apex + step, **how)

            for column, name in enumerate(found["by"].values):
                up, down = moved(name, 1e-6), moved(name, -1e-6)
                for of in ("next_apex", "speed", "cost_of_transport"):
                    difference = (up[of].values[0, 0] - down[of].values[0, 0]) / 2e-6
                    exact = found[f"{of}_by"].values[number, stride][..., column]
                    assert exact == pytest.approx(difference, rel=2e-5, abs=2e-6), (name, of)
