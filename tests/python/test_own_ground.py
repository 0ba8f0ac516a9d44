"""Ground that varies below models of pages: the package's runner as a page is the built-in runner."""

import numpy as np
import own_pages
import pytest
from conftest import release
from tdmf_slip import AffineLaw, Batch, InputError, RoughGround, find_gait, rare_falls, strides_to_fall
from tdmf_slip.library.engine import FATES
from tdmf_slip.library.ground import correlated_weights
from tdmf_slip.library.page_model import package_model

RUNNERS = 40
GROUNDS = {
    "steps": RoughGround(0.3, 3),
    "steps that trip": RoughGround(0.3, 3, trips=True),
    "correlated steps and friction": RoughGround(
        0.2, 3, correlated_weights(0.5), friction_spread=0.3, friction_weights=(0.8, 0.6)
    ),
    "terrain": RoughGround(0.3, 3, segment_length=4.0, friction_spread=0.2),
    "terrain that trips": RoughGround(0.2, 3, segment_length=4.0, trips=True),
    "heights": RoughGround(segment_length=3.0, heights=(0.0, 0.1, -0.1, 0.05)),
}


@pytest.fixture(scope="module")
def page():
    """The package's runner as a page, which runs as a model of one's own does."""
    return package_model("runner", "at_apex")


@pytest.fixture(scope="module")
def starts(gait):
    return gait.apex + np.random.default_rng(0).uniform(-0.05, 0.05, (RUNNERS, 6))


def assert_same_runs(mine, own, within):
    np.testing.assert_array_equal(mine.fate, own.fate)
    np.testing.assert_array_equal(mine.strides, own.strides)
    for name in ("apex", "foot_x", "time"):
        np.testing.assert_allclose(mine[name], own[name], rtol=0, atol=within, err_msg=name)
    recorded, reference = mine.recorded, own.recorded
    np.testing.assert_array_equal(recorded["word"], reference["word"])
    for name in reference:
        if reference[name].dtype.kind == "f":
            np.testing.assert_allclose(
                recorded[name], reference[name], rtol=1e-12, atol=max(within, 1e-13), err_msg=name
            )


@pytest.mark.parametrize("name", GROUNDS)
def test_runs_over_drawn_ground_and_terrain_are_those_of_the_built_in_runner(page, gait, starts, name):
    """Apices are equal to the bit."""
    feet = np.random.default_rng(1).uniform(-5, 5, RUNNERS)
    for foot_x in (None, feet):
        mine, own = (
            Batch(runner, starts, GROUNDS[name], foot_x=foot_x, first_number=7).run(12, record=True)
            for runner in (page, {})
        )
        assert_same_runs(mine, own, 0.0)
        assert own.strides.sum() > RUNNERS and np.ptp(own.foot_x) > 1


def test_lines_set_by_laws_wait_and_patches_are_met_as_by_the_built_in_runner(page, gait, starts):
    """The built-in runner of a patch runs on another page, which has the same laws in other rounding."""
    rises = np.random.default_rng(2).uniform(-0.5, 0.5, (RUNNERS, 12)).cumsum(axis=1)
    slope = AffineLaw(["ground.slope"], gait.apex, [0.0], [[0.02] * 6], [-0.1], [0.1], [1e-3] * 6)
    patch = {"ground.patch_begin": 20.0, "ground.patch_end": 40.0, "ground.patch_friction": 0.02}
    for given, how in (
        ({}, {"inputs": {"ground.height": rises}}),
        ({}, {"law": lambda apices, k: {"ground.height": rises[:, k]}}),
        ({}, {"law": slope}),
        (patch, {"foot_x": np.linspace(-20, 20, RUNNERS)}),
    ):
        mine, own = (
            Batch(given, starts, model=model, **(how if model is None else by_page(how, page))).run(
                12, record=True
            )
            for model in (page, None)
        )
        assert_same_runs(mine, own, 1e-9)
    assert (own.fate == FATES.index("undecided")).any()


def by_page(how, page):
    """The same arguments, with a law of the page."""
    law = how.get("law")
    if not isinstance(law, AffineLaw):
        return how
    own = AffineLaw(law.inputs, law.apex, law.nominal, law.gain, law.low, law.high, law.noise, model=page)
    return {"law": own}


def test_saved_states_and_single_steps_go_on_over_the_same_ground(page, starts):
    for ground in (GROUNDS["correlated steps and friction"], GROUNDS["terrain"]):
        whole = Batch(page, starts, ground).run(6)
        stepping = Batch(page, starts, ground)
        for _ in range(3):
            stepping.step()
        saved = stepping.save()
        later = Batch(page, starts[:1], ground)
        later.resume(saved, 3)
        for _ in range(3):
            stepping.step()
            fates = later.step()
        np.testing.assert_array_equal(stepping.apices, whole.apex)
        np.testing.assert_array_equal(later.apices, whole.apex)
        np.testing.assert_array_equal(fates, whole.fate)


def test_falls_are_those_of_the_built_in_runner(page):
    gaits = find_gait(page), find_gait()
    ground = RoughGround(0.5, 2, step_weights=(0.8, 0.6), friction_spread=0.1)
    mine, own = (strides_to_fall(gait, ground, 60, max_strides=40, gait=gaits[1]) for gait in gaits)
    assert (mine.falls, mine.strides) == (own.falls, own.strides) and own.falls > 10


@release
def test_rare_falls_are_those_of_the_built_in_runner(page):
    mine, own = (rare_falls(runner, 0.5, walkers=8, strides=8, seed=1) for runner in (page, {}))
    assert mine.mean_strides == pytest.approx(own.mean_strides, rel=1e-9) and own.falls > 100


def test_pages_without_ground_refuse_it(ball):
    refusal = r"has no ground that varies from place to place; allowed: the full model, and models of one's"
    level = own_pages.my_runner()
    for model, apex in ((ball, [1.0]), (level, find_gait(level).apex)):
        assert not model.has_ground
        for what, given in (("ground", {"ground": RoughGround(0.1)}), ("foot_x", {"foot_x": 1.0})):
            with pytest.raises(InputError, match=f"{what}: the model {model.name} {refusal}"):
                Batch(model, apex, **given)
    with pytest.raises(InputError, match=f"runner: the model my_runner {refusal}"):
        strides_to_fall(level, 0.3, 10, max_strides=5)
    with pytest.raises(InputError, match=f"runner: the model my_runner {refusal}"):
        rare_falls(level, 0.3)
