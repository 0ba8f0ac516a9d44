"""Gaits as fixed points of the return map: eigenvalues, borders between words, branches, sweeps on file."""

import pickle
from dataclasses import replace
from itertools import pairwise, product
from pathlib import Path

import numpy as np
import pytest
from conftest import CLAMPED, release
from references import FREE
from tdmf_slip import Batch, InputError, RunError, Runner, find_gait
from tdmf_slip.analysis.along import gaits_over
from tdmf_slip.analysis.gait_problem import BranchProblem
from tdmf_slip.analysis.search import periodic_gait
from tdmf_slip.analysis.sweeps import gait_at, sweep
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.events import LETTERS
from tdmf_slip.library.return_map import stride_from
from tdmf_slip.record import runner_in
from tdmf_slip.variables.parameters import read_parameters
from tdmf_slip.variables.table import FRICTION, MODELS

CLAMP = "hip.swing_clamp"
FAST_HUMAN = Path(__file__).with_name("fast_human.toml")

EIGENVALUES = {
    (10.0, 0.1, 0.2): (0.811488219, -0.463835571, 0.010024837, 0.0, 0.0, 0.0),
    (0.6, 0.1, 0.2): (0.857395094, -0.372498323, 0.00869537996, 0.0, 0.0, 0.0),
    (0.6, 0.005, 1.0): (0.897504, -0.276227),
    (0.3, 0.02, 2.0): (0.675120,),
}
"""Leading eigenvalues with the clamp of the swing, by friction, foot mass and damping.

They are independent: of fixed points refined in extended precision, and differenced there.
"""
BORDERS = {(border["from"], border["to"]): border["friction"] for border in FREE["borders"]}


@pytest.fixture(scope="module")
def swept(runner):
    return sweep(runner, {FRICTION: np.geomspace(10.0, 0.05, 24)})


@pytest.fixture(scope="module")
def borders(swept):
    """Frictions of the borders by the words above and below."""
    columns = (swept.borders[name].values for name in ("before", "after", FRICTION))
    return {(before, after): friction for before, after, friction in zip(*columns, strict=True)}


@pytest.mark.parametrize("given", EIGENVALUES)
def test_gaits_with_the_clamp_have_their_eigenvalues(given):
    """A foot that sticks makes three of them vanish."""
    gait = find_gait(Runner(dict(zip((FRICTION, "foot.mass", "leg.damping"), given, strict=True)) | CLAMPED))
    known = EIGENVALUES[given]
    assert gait.eigenvalues[: len(known)] == pytest.approx(known, abs=1e-6 if len(known) < 6 else 1e-8)
    assert gait.stable


def test_a_stride_without_derivatives_is_said_to_have_none():
    """A servo that is clamped at zero has none by its gains where they are zero."""
    apex = [1.2, 0.3, 1.0, 0.6, 0.0, -0.05]
    without = Runner({"hip.kp": 0.0, "hip.kd": 0.0, "hip.stance_torque": 0.0, **CLAMPED})
    assert all(np.isfinite(values).all() for values in stride_from(without, apex, "hip.stance_torque"))
    with pytest.raises(RunError, match="no derivatives"):
        stride_from(without, apex, "hip.kp")


def test_without_stick_two_eigenvalues_vanish(runner):
    values = np.abs(find_gait(runner.replace({FRICTION: 0.2})).eigenvalues)
    assert 1e-8 < values[3] < 1e-6
    assert values[4:] == pytest.approx([0.0, 0.0], abs=1e-9)


def test_eigenvalues_tell_how_fast_a_disturbance_dies(runner):
    """Run, not linearized: after some strides only the slowest direction is left."""
    gait = find_gait(runner)
    section = gait.apex + np.array([0, 1e-4, 0, 0, 0, 0])
    distances = []
    for _ in range(2):
        section, _ = runner.settle(section, 20)
        distances.append(np.linalg.norm(section - gait.apex))
    rate = (distances[1] / distances[0]) ** (1 / 20)
    assert rate == pytest.approx(abs(gait.eigenvalues[0]), rel=1e-4)


def test_borders_do_not_depend_on_the_way_they_are_met(runner, borders):
    found = borders
    assert found == pytest.approx(BORDERS, abs=1e-9)
    gaits, borders = sweep(runner, {FRICTION: np.linspace(0.05, 10.0, 9)})
    assert gaits["problem"].item() == "" and borders.sizes["border"] == len(found)
    for value, before, after in zip(
        *(borders[of].values for of in (FRICTION, "before", "after")), strict=True
    ):
        assert found[after, before] == pytest.approx(value, rel=1e-9)


def test_a_word_in_a_window_of_a_few_millionths(runner, borders):
    """The foot stops so near lift-off that it cannot stick, and slips forward before it leaves."""
    inner = {words: friction for words, friction in borders.items() if "+0-+" in words}
    assert list(inner) == [("+0-0+", "+0-+"), ("+0-+", "+0-")]
    high, low = inner.values()
    assert high - low == pytest.approx(BORDERS["+0-0+", "+0-+"] - BORDERS["+0-+", "+0-"], abs=1e-9)
    around = find_gait(runner.replace({FRICTION: 0.5}))
    within = next(gaits_over(runner, FRICTION, [0.5 * (high + low)], around))
    assert within.word == "+0-+"


def test_every_border_lies_between_its_words(runner, borders):
    for words, friction in borders.items():
        near = find_gait(runner.replace({FRICTION: friction * (1.0 + 1e-7)}))
        beyond = next(gaits_over(runner, FRICTION, [friction * (1.0 - 1e-7)], near))
        assert (near.word, beyond.word) == words
        within = sweep(runner, {FRICTION: [near.friction, beyond.friction]}).borders[FRICTION]
        assert within.values == pytest.approx([friction], rel=1e-9)


def test_a_grid_has_each_gait_with_its_units(runner):
    frictions, rows = np.linspace(0.5, 0.7, 3), np.linspace(0.18, 0.22, 3)
    gaits, borders = sweep(runner, {"ground.friction": frictions, "leg.damping": rows})
    assert gaits["period"].dims == ("ground.friction", "leg.damping")
    assert int(gaits["period"].notnull().sum()) == 9 and gaits["period"].attrs["units"] == "s"
    values = runner_in(gaits)
    assert values["leg.stiffness"] == 1.0 and "leg.damping" not in values
    middle = find_gait(runner.replace({FRICTION: 0.6}))
    assert float(gaits["period"][1, 1]) == pytest.approx(middle.period, rel=1e-11)
    spectrum = gaits["eigenvalue_real"][1, 1] + 1j * gaits["eigenvalue_imag"][1, 1]
    np.testing.assert_allclose(spectrum, middle.eigenvalues, atol=1e-9)
    again = gait_at(gaits, friction=0.6, **{"leg.damping": 0.2})
    assert again.word == middle.word and again.runner == middle.runner
    np.testing.assert_allclose(again.apex, middle.apex, atol=1e-11)
    assert set(borders["before"].values) == {"+0-", "+0-+"}
    assert set(borders["leg.damping"].values) <= {*rows}
    for where, message in (
        ({"friction": 0.65}, "friction = 0.65 is not in the sweep"),
        ({"friction": 0.6}, "give a value of leg.damping, too"),
        ({"torque": 0.2}, "hip.stance_torque does not vary; give ground.friction, leg.damping"),
    ):
        with pytest.raises(InputError, match=message):
            gait_at(gaits, **where)
    for given in (None, sweep, borders, gaits.drop_attrs(), gaits.drop_vars("apex_com_height")):
        with pytest.raises(InputError, match=r"gaits = .* allowed: a dataset of gaits"):
            gait_at(given, friction=0.6)


def test_a_gait_has_all_quantities_as_attributes_and_as_a_dataset(runner):
    gait = find_gait(runner)
    assert len(gait.stride) == 29
    data = gait.to_dataset()
    for name, value in gait.stride.items():
        assert getattr(gait, name) == value == data[name].item() and name in dir(gait)
        assert data[name].attrs["units"] == MODELS["full"].quantities[name].unit
    assert np.array_equal(data["jacobian"], gait.jacobian) and data.attrs["result"] == "gait"
    with pytest.raises(AttributeError, match="a gait has no 'sped'; near matches: speed"):
        _ = gait.sped
    assert pickle.loads(pickle.dumps(gait)).speed == gait.speed


def test_the_search_begins_at_an_apex_whatever_the_masses(runner):
    """The start values of the default masses have a vertical velocity of the centre of mass with others."""
    for name, value in (("foot.mass", 0.2), ("body.mass", 0.9)):
        other = runner.replace({name: value})
        state = other.state_at(other.start_apex())
        for kept in ("leg.length", "leg.angle", "leg.length_rate", "leg.angle_rate", "foot.y", "foot.vx"):
            assert state[kept] == pytest.approx(runner[kept], abs=1e-14)
        assert find_gait(other).error < 1e-12


def test_events_and_letters_are_those_of_one_stride():
    """A word's letters with their durations, in stances of their own too."""
    human = Runner(read_parameters(FAST_HUMAN))
    gaits = [find_gait(human.replace({"leg.stiffness": k})) for k in (2e4, 1.95e4, 1.9e4, 1.75e4, 1.7e4)]
    assert {gait.word for gait in gaits} == {"+0+", "+|+0+"}
    for gait in gaits:
        assert "".join(letter.letter for letter in gait.letters) == gait.word.replace("|", "")
        times = [event.time for event in gait.events]
        assert times == sorted(times) and times[0] >= 0.0 and times[-1] <= gait.period * (1.0 + 1e-9)
        standing = [
            after.time - event.time
            for event, after in pairwise(gait.events)
            if event.contact_after in LETTERS
        ]
        assert sum(letter.duration for letter in gait.letters) == pytest.approx(sum(standing), rel=1e-12)
        assert 0.0 < sum(standing) <= gait.stride["stance_time"] * (1.0 + 1e-9)


def test_a_grid_keeps_the_gaits_before_its_branch_was_lost(runner):
    frictions = np.linspace(0.6, 0.02, 4)
    found = sweep(runner, {"hip.touchdown_angle": [1.0], "ground.friction": frictions}).gaits
    known = np.isfinite(found["period"].values[0]).tolist()
    assert known == [True, True, False, False] and str(found["problem"].values[0])
    assert found["word"].values[0].tolist()[2:] == ["", ""]
    first = find_gait(runner.replace({"hip.touchdown_angle": 1.0}))
    assert float(found["lambda_max"][0, 0]) == pytest.approx(np.max(np.abs(first.eigenvalues)), rel=1e-9)
    for name in ("speed", "work", "impact_loss"):
        assert float(found[name][0, 0]) == pytest.approx(first.stride[name], rel=1e-9)
    with pytest.raises(RunError, match=r"at friction 0\.02"):
        find_gait(runner.replace({"hip.touchdown_angle": 1.0, FRICTION: 0.02}))


@release
def test_a_sweep_goes_on_beyond_a_gap():
    """Gaits of different words on different branches have no border between them."""
    gaits, borders = sweep(Runner(read_parameters(FAST_HUMAN)), {FRICTION: [0.6, 0.3, 0.405]})
    assert gaits["word"].values.tolist() == ["+0+", "", "+0-0+"]
    assert "friction 0.3" in gaits["problem"].item() and borders.sizes["border"] == 0


def test_a_border_that_is_not_located_loses_no_gait(runner, monkeypatch):
    def failing(*_):
        raise RunError("no convergence")

    monkeypatch.setattr(BranchProblem, "border", failing)
    found = sweep(runner, {FRICTION: [0.6, 0.45]}).gaits
    problem = "border of +0-0+ not located near ground.friction = 0.6: no convergence"
    assert (found["word"] != "").all() and found["problem"].item() == problem


def test_a_grid_over_a_mass(runner):
    """A row whose start values are refused has its reason, and the others are done."""
    found = sweep(runner, {"ground.friction": [0.6], "foot.mass": [0.1, 0.2]}).gaits
    assert not found["period"].isnull().any()
    found = sweep(runner, {"ground.friction": [0.6], "leg.length": [0.04, runner["leg.length"]]}).gaits
    assert "leg.length = 0.04" in str(found["problem"].values[0]) and found["problem"].values[1] == ""


def test_what_was_not_asked_for_is_absent(runner):
    """Derivatives that were not asked for are None, because zero would be a result."""
    plain, along = find_gait(runner), periodic_gait(runner, along="leg.damping")
    assert plain.along is None and plain.by_parameter is None
    assert along.along == "leg.damping"
    changed = find_gait(runner.replace({"leg.damping": runner["leg.damping"] + 1e-6}), guess=plain.apex)
    slope = np.linalg.solve(np.eye(6) - along.jacobian, along.by_parameter)
    assert (changed.apex - plain.apex) / 1e-6 == pytest.approx(slope, rel=1e-3, abs=1e-6)


def test_what_cannot_be_found_is_said(runner):
    with pytest.raises(RunError, match=r"no gait at friction 0\.6: the runner fell"):
        find_gait(runner.replace({"hip.stance_torque": 0.0}))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--output", "grid.nc"), ["grid.nc", "holds a sweep"]),
        (("--vary", "leg.damping=0.1:0.2:2", "--output", "text.nc"), ["text.nc"]),
        (("--vary", "leg.damping=0.1:0.3:2", "--output", "grid.nc"), ["leg.damping"]),
    ],
)
def test_a_sweep_is_not_written_into_another_file(command, tmp_path, options, words):
    (tmp_path / "text.nc").write_text("nothing")
    grid = ("--friction", "0.3:0.4:2", "--vary", "leg.damping=0.1:0.2:2", "--output", "grid.nc")
    assert command("sweep", *grid)[0] == 0
    said = command.refusal("sweep", "--friction", "0.3:0.4:2", *options)
    assert all(word in said for word in words), said
    assert sorted(path.name for path in tmp_path.iterdir()) == ["grid.nc", "text.nc"]


def test_a_light_foot_that_never_slips_has_a_gait():
    """Stick ends where the ground force does, up to the friction times rounding; no event is found twice.

    The period is that which runs of the unit by CVODE settle to.
    """
    light = {"foot.mass": 0.02, "hip.touchdown_angle": "49.6715 deg", "ground.friction": 1000.0}
    gait = find_gait(Runner(light))
    assert (gait.word, gait.stable) == ("0+", True)
    assert gait.period == pytest.approx(25.36965, rel=3e-7)


def test_friction_without_bound_has_the_gait_of_no_slip(runner):
    """The effect of friction vanishes like its inverse."""
    never = find_gait(runner.replace({FRICTION: 1e6}))
    for friction in (1e3, 1e4, 1e5):
        gait = find_gait(runner.replace({FRICTION: friction}))
        assert gait.word == never.word == "0+"
        assert gait.period == pytest.approx(never.period, rel=1e-3 / friction)


def test_trouble_of_the_solver_is_not_called_a_fall():
    """A servo so stiff that no step changes the time; whether the runner falls is not known."""
    stiff = Runner({"foot.mass": 1e-12, "hip.kp": 1e18, "hip.kd": 1e18})
    apex = [1.34, 0.95, 1.0, 0.93, 0.0, 0.2]
    for search, made in (
        (lambda: find_gait(stiff), "after 0 strides, 2 steps and 0 events"),
        (lambda: find_gait(stiff, guess=apex), "after 0 strides, 1 step and 0 events"),
        (lambda: stride_from(stiff, apex, FRICTION), ""),
    ):
        with pytest.raises(RunError, match=r"too stiff|no step") as trouble:
            search()
        assert "fell" not in str(trouble.value) and made in str(trouble.value)
    assert FATES[Batch(stiff, apex).run(3).fate] == "unsolved"


@pytest.mark.parametrize("model", ["full", "reduced"])
def test_a_gait_tells_where_its_energy_comes_from_and_goes_to(command, model):
    actuated = ("--set", "ground.slope=1 deg", "--set", "leg.thrust=0.01", "--set", "body.external_fx=1e-4")
    gait = command.json("gait", "--friction", 0.6, *actuated, "--model", model)
    gained = gait["work"] + gait["external_work"]
    lost = gait["damper_loss"] + gait["friction_loss"] + gait["impact_loss"]
    assert gait["rise"] == pytest.approx(gait["length"] * np.tan(np.radians(1.0)), abs=1e-9)
    assert gait["work"] == pytest.approx(gait["hip_work"] + gait["leg_work"], abs=1e-15)
    assert gait["leg_work"] > 0.0 and gait["external_work"] > 0.0
    if model == "full":  # what is left in the leg at lift-off is no loss of these
        assert gained - lost == pytest.approx(1.1 * 0.01 * gait["rise"], abs=1e-9)


def test_no_gait_is_stable_with_an_eigenvalue_outside_the_unit_circle(runner):
    """Wherever it is in the Jacobian; what was computed for another Jacobian does not matter."""
    gait = find_gait(runner)
    assert gait.stable and gait.unstable == 0
    for place, largest in product(range(6), (4.0, -4.0, 1.0, np.nextafter(1.0, 2.0))):
        sizes = np.full(6, 0.5)
        sizes[place] = largest
        other = replace(gait, jacobian=np.diag(sizes))
        assert not other.stable and other.as_json()["stable"] is False
        assert other.lambda_max == abs(largest)
