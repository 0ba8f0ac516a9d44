"""Analyses of models of users' own: a page that is the package's runner gives what the runner gives."""

import numpy as np
import own_pages
import pytest
import tdmf_slip
from conftest import ROOT
from tdmf_slip import (
    AffineLaw,
    Batch,
    InputError,
    Runner,
    basin,
    continue_branch,
    dead_beat,
    find_gait,
    gait_at,
    lqr,
    stride_map,
    sweep,
)
from tdmf_slip.library.page_model import package_model

NO_GAINS = {"hip.stance_kp": 0.0, "hip.stance_kd": 0.0}
AXES = {"com_height": (0.9, 2.4), "com_speed": (0.3, 1.8)}
SETTINGS = ["hip.touchdown_angle", "hip.stance_torque"]


@pytest.fixture(scope="module")
def paper_s(my_runner):
    """The paper's runner by a page of one's own."""
    return Runner(my_runner, **NO_GAINS)


def test_the_branch_over_friction_has_the_borders_of_the_built_in_runner(paper_s):
    span = {"ground.friction": (0.6, 0.4)}
    mine, own = continue_branch(paper_s, span), continue_branch({}, span)
    specials = [data.isel(point=data["special"].values != "") for data in (mine, own)]
    kinds, values = (
        [list(data[name].values) for data in specials] for name in ("special", "ground.friction")
    )
    assert kinds[0] == kinds[1] and len(kinds[0]) >= 2
    assert values[0] == pytest.approx(values[1], abs=1e-8)
    assert mine.attrs["ended"] == own.attrs["ended"] == "end of the range"


def test_a_sweep_has_the_gaits_of_the_built_in_runner(paper_s):
    values = {"friction": [0.7, 0.6, 0.43]}
    (mine, borders), (own, other) = sweep(paper_s, values), sweep(None, values)
    for name in ("period", "speed", "cost_of_transport", "lambda_max", "apex_com_height"):
        assert mine[name].values == pytest.approx(own[name].values, abs=1e-8), name
    assert (mine["word"].values == own["word"].values).all()
    assert borders["ground.friction"].values == pytest.approx(other["ground.friction"].values, abs=1e-8)
    assert gait_at(mine, friction=0.43).word == "+0-"


def test_settings_by_stride_optima_and_dead_beat_laws_are_those_of_the_built_in_runner(paper_s):
    inputs = {"friction": [0.6, 0.5, 0.7], "hip.stance_torque": np.array([[0.2, 0.21, 0.19]])}
    vary, gaits = {"hip.stance_torque": (0.15, 0.25)}, (find_gait(paper_s), find_gait())
    mine, own = (Batch(gait.runner, gaits[1].apex, inputs=inputs).run(3).apex for gait in gaits)
    assert mine == pytest.approx(own, abs=1e-7) and np.abs(own - gaits[1].apex).max() > 1e-3
    stepping = Batch(paper_s, gaits[1].apex)
    for k in range(3):
        stepping.step({name: np.ravel(values)[k] for name, values in inputs.items()})
    assert stepping.apices[0] == pytest.approx(own, abs=1e-7)
    mine, own = (tdmf_slip.optimize(gait, vary, minimize="cost_of_transport", starts=1) for gait in gaits)
    assert mine.parameters == pytest.approx(own.parameters, abs=1e-6)
    mine, own = (dead_beat(gait, SETTINGS) for gait in gaits)
    assert np.asarray(mine.gain) == pytest.approx(np.asarray(own.gain), abs=1e-5)


def test_feedback_and_runs_under_it_are_those_of_the_built_in_runner(paper_s):
    mine, own = lqr(find_gait(paper_s), SETTINGS), lqr(find_gait(), SETTINGS)
    assert np.asarray(mine.gain) == pytest.approx(np.asarray(own.gain), abs=1e-6)
    starts = np.asarray(own.apex) + np.random.default_rng(2).uniform(-0.05, 0.05, (30, 6))
    for law, other in ((mine, own), (lambda a, k: mine(a, k), lambda a, k: own(a, k))):
        run = Batch(paper_s, starts, law=law).run(8, record=True)
        reference = Batch({}, starts, law=other).run(8, record=True)
        assert (run.fate == reference.fate).all() and (run.strides == reference.strides).all()
        closed = run.strides == 8
        assert run.apex[closed] == pytest.approx(reference.apex[closed], abs=1e-6)
        for name in SETTINGS:
            recorded = run.recorded[name][closed]
            assert recorded == pytest.approx(reference.recorded[name][closed], abs=1e-6)


def test_a_basin_is_that_of_the_built_in_runner(paper_s):
    mine, own = basin(paper_s, AXES, 6, ball="none"), basin(None, AXES, 6, ball="none")
    np.testing.assert_array_equal(mine["fate"], own["fate"])
    np.testing.assert_array_equal(mine["strides_until_known"], own["strides_until_known"])


def test_a_target_and_a_branch_of_the_ball_are_those_of_the_closed_form(ball):
    """The speed after an impact is push/(1 - restitution), the period twice that over gravity."""
    gait = find_gait(ball, target={"period": 1.2}, vary=["push"])
    assert gait.runner["push"] == pytest.approx(1.2 / 2 * 9.81 * 0.2, rel=1e-9)
    branch = continue_branch(ball, {"restitution": (0.3, 0.9)})
    values = branch["restitution"].values
    assert branch["apex_height"].values == pytest.approx((1 / (1 - values)) ** 2 / 2 / 9.81, rel=1e-9)
    assert branch["lambda_max"].values == pytest.approx(values, abs=1e-9)


def test_a_fit_finds_the_runner_of_the_built_in_one(paper_s):
    gait = find_gait(touchdown_angle=0.7, torque=0.21)
    data = {name: [gait.stride[name]] for name in ("speed", "period", "peak_force")}
    data["frequency"] = 1 / np.array(data.pop("period"))
    vary, errors = ["hip.stance_torque", "touchdown_angle"], dict.fromkeys(data, "1 %")
    mine, own = (tdmf_slip.fit(runner, data, vary, errors=errors) for runner in (paper_s, None))
    assert mine.converged and mine.chi_square < 1e-12
    for name in own.parameters:
        one, other = mine.parameters[name], own.parameters[name]
        assert (one.value, one.low, one.high) == pytest.approx((other.value, other.low, other.high), rel=1e-6)
    assert len(tdmf_slip.plot(mine).axes) > 3 and "hip.stance_torque" in mine.as_text()


def test_a_fit_of_the_ball_is_the_closed_form(ball):
    """The period 2 push/(1 - e)/g and the speed at the impact push/(1 - e) identify push and gravity."""
    data, errors = {"impact_speed": [4.0], "period": [2.0]}, {"impact_speed": 0.1, "period": 0.1}
    found = tdmf_slip.fit(ball, data, ["push", "gravity"], errors=errors)
    assert found.parameters["push"].value == pytest.approx(0.8, rel=1e-8)
    assert found.parameters["gravity"].value == pytest.approx(4.0, rel=1e-8)
    with pytest.raises(InputError, match="column 'speed' is unknown; allowed: period, impact_speed"):
        tdmf_slip.fit(ball, {"speed": [1.0]}, ["push"], errors={})
    with pytest.raises(InputError, match=r"friction.* is not allowed.*; allowed: a parameter or input"):
        tdmf_slip.fit(ball, data, ["friction"], errors=errors)


def test_a_viable_set_is_that_of_the_built_in_runner(paper_s):
    """Starts have the same leg as those of the built-in runner."""
    vary = {"hip.touchdown_angle": (0.3, 1.1, 5), "hip.stance_torque": (0.1, 0.3, 2)}
    gait, settings = find_gait(paper_s), {"axes": AXES, "vary": vary, "n": 6}
    own = tdmf_slip.viability(None, model="full", **settings)
    leg = [1.0, Runner()["hip.touchdown_angle"], 0.0, 0.0]
    mine = tdmf_slip.viability(paper_s, gait=[*gait.apex[:2], *leg], **settings)
    np.testing.assert_array_equal(mine["fate"], own["fate"])
    np.testing.assert_array_equal(mine["viable_pair"], own["viable_pair"])
    assert mine["next_com_speed"].values == pytest.approx(own["next_com_speed"].values, abs=1e-6, nan_ok=True)
    assert mine["inner_drop"].values == pytest.approx(own["inner_drop"].values, nan_ok=True)
    law, other = (tdmf_slip.ViableController(of) for of in (mine, own))
    assert law.as_table() == other.as_table() and law.inputs_at(gait.apex) == other.inputs_at(gait.apex)
    run = Batch(paper_s, gait.apex, law=law).run(3)
    assert run.strides == 3
    assert tdmf_slip.plot(mine).axes[0].get_ylabel().startswith("height of the centre of mass")


def test_a_map_of_a_walker_is_over_its_own_coordinates():
    """The simplest walker has a section of two coordinates, which are no apex's."""
    walker = own_pages.loaded(ROOT / "examples" / "pages" / "simplest_walker.py")
    gait = find_gait(walker)
    first, second = walker.coordinates
    axes = {name: (at - 2e-3, at + 2e-3) for name, at in zip((first, second), gait.apex, strict=True)}
    found = basin(walker, axes, 3, ball="none")
    assert found["fate"].dims == (first, second) and found["fate"].values[1, 1] == 0
    assert tdmf_slip.plot(found).axes[0].get_xlabel().startswith(second.replace("_", " "))
    made = stride_map(walker, gait.apex[None], strides=2)
    assert len(tdmf_slip.plot(made).axes) == 2


def test_a_simulation_of_the_ball_by_its_unit_is_its_parabolas(ball):
    run = tdmf_slip.simulate(Runner(ball, push=0.0, height=2.0), stop_time=1.5, output_interval=0.01)
    assert run.attrs["model"] == "my_ball" and len(tdmf_slip.plot(run).axes) >= 2
    times, falls = run["time"].values, np.sqrt(4 / 9.81)
    flight = times < falls - 1e-6
    assert flight.sum() > 60
    assert run["height"].values[flight] == pytest.approx(2 - 9.81 / 2 * times[flight] ** 2, abs=1e-7)
    after = (times > falls + 1e-6) & (times < falls + 1.5 * falls)
    since, speed = times[after] - falls, 0.8 * 9.81 * falls
    assert run["height"].values[after] == pytest.approx(speed * since - 9.81 / 2 * since**2, abs=1e-6)
    assert run["energy"].values[flight] == pytest.approx(9.81 * 2, abs=1e-6)
    assert run["energy"].values[after] == pytest.approx(0.64 * 9.81 * 2, abs=1e-6)
    steps = tdmf_slip.simulate(Runner(ball, push=0.0), stop_time=1.0, interface="cs", variables=["height"])
    assert "height" in steps and "energy" not in steps and steps.sizes["time"] == 1001
    with pytest.raises(InputError, match=r"strides: the unit MyBall.fmu does not count strides; give stop_"):
        tdmf_slip.simulate(ball, strides=3)


def test_a_gait_on_sloped_ground_by_the_whole_page_is_that_of_the_built_in_runner():
    """The page also has a held state that is called `ground.slope`: the slope of the line in force."""
    given = {"ground.slope": 0.02, "ground.height": 0.5, "friction": 0.43}
    by_page = Runner(package_model("runner", "at_apex"), **given)
    mine, own = find_gait(by_page), find_gait(**given)
    assert mine.apex == pytest.approx(own.apex, abs=1e-10)
    assert mine.stride["rise"] == pytest.approx(own.stride["rise"], abs=1e-10) and own.stride["rise"] > 0.1


def test_derivatives_of_a_trajectory_are_those_of_the_engine(paper_s):
    """Derivatives by more names than the library varies at once, and by a parameter of one's own."""
    gait = find_gait(paper_s)
    times = np.linspace(0, 1.29 * gait.period, 40)
    names = [*gait.runner.coordinates, "leg.damping", "friction", "body.mass", "gravity", "leg.stiffness"]
    names += ["hip.stance_torque", "hip.touchdown_angle", "hip.kp", "hip.kd", "foot.mass"]
    mine, own = (
        tdmf_slip.trajectory(runner, gait.apex, times=times, derivatives=names) for runner in (paper_s, None)
    )
    for name in ("com.y", "com.vx", "leg.angle", "hip.torque", "energy.total", "foot.vx"):
        wanted = own[f"d_{name}"].values
        assert mine[f"d_{name}"].values == pytest.approx(wanted, rel=1e-6, abs=1e-6), name
    (by,) = ["hip.stance_kp"]
    found = tdmf_slip.trajectory(paper_s, gait.apex, times=times, derivatives=["stance_kp"])
    ahead, at = (
        tdmf_slip.trajectory(paper_s.replace({by: kp}), gait.apex, times=times)["com.vx"].values
        for kp in (1e-6, 0.0)
    )
    assert found["d_com.vx"].sel(by=by).values == pytest.approx((ahead - at) / 1e-6, abs=1e-4)


def test_derivatives_of_a_run_from_the_start_are_the_closed_form(ball):
    times = np.array([0.1, 0.3, 1.0])
    run = tdmf_slip.trajectory(ball, times=times, derivatives=["restitution", "gravity"])
    falls = np.sqrt(2 * Runner(ball)["height"] / 9.81)
    assert times[1] < falls < times[2] < 2.5 * falls
    assert run["d_height"].sel(by="gravity").values[:2] == pytest.approx(-(times[:2] ** 2) / 2, abs=1e-12)
    assert run["d_height"].sel(by="restitution").values == pytest.approx(
        [0, 0, 9.81 * falls * (1 - falls)], abs=1e-10
    )
    with pytest.raises(
        InputError, match="a run from the start values has no apex; allowed: by coordinates with apex"
    ):
        tdmf_slip.trajectory(ball, times=times, derivatives=["height"])


def test_what_needs_the_package_s_own_models_says_so(my_runner, ball):
    with pytest.raises(
        InputError, match="runner of the model my_runner: this function takes only the package's own models"
    ):
        tdmf_slip.prove(my_runner)
    with pytest.raises(InputError, match=r"stiffness.* is neither an argument nor a variable"):
        find_gait(ball, stiffness=1)
    with pytest.raises(InputError, match="push cannot change in a run; allowed: none; a page declares"):
        Batch(ball, [1.0], inputs={"push": 2.0})


@pytest.mark.parametrize("draw", ["branch", "sweep", "gait", "strides", "trajectory"])
def test_pictures_of_a_model_without_a_runner_s_quantities_are_drawn(ball, draw):
    pytest.importorskip("matplotlib")
    made = {
        "branch": lambda: continue_branch(ball, {"restitution": (0.3, 0.5)}),
        "sweep": lambda: sweep(ball, {"restitution": [0.3, 0.5]}).gaits,
        "gait": lambda: find_gait(ball),
        "strides": lambda: stride_map(ball, [[0.5], [0.7]], strides=3),
        "trajectory": lambda: tdmf_slip.trajectory(ball, times=np.linspace(0, 1, 20)),
    }
    assert len(tdmf_slip.plot(made[draw]()).axes) >= 1


def test_runs_are_the_same_by_engine_function_steps_saved_states_and_parts(my_runner):
    """Bit for bit; without a record nothing is observed along strides, whose steps may then be longer."""
    gait, rng = find_gait(my_runner), np.random.default_rng(3)
    starts, angle = gait.apex + rng.uniform(-0.1, 0.1, (40, 6)), gait.runner[SETTINGS[0]]
    noisy = AffineLaw(
        SETTINGS[:1], gait.apex, [angle], [[0.02] * 6], [angle - 0.01], [angle + 0.01], [1e-3] * 6,
        model=my_runner,
    )  # fmt: skip

    def run(law, some=slice(None), **how):
        return Batch(gait, starts[some], law=law, **how).run(4, record=True)

    found = run(noisy)
    closed = found.strides == 4
    assert closed.sum() > 10 and len(np.unique(found.recorded[SETTINGS[0]])) > 40
    alike = (run(lambda apices, k: noisy(apices, k)), run(noisy, instructions="one by one", threads=1))
    for other in alike:
        for name in found.recorded:
            np.testing.assert_array_equal(other.recorded[name], found.recorded[name], err_msg=name)
    part = run(noisy, slice(7, 19), first_number=7)
    np.testing.assert_array_equal(part.apex, found.apex[7:19])
    stepping = Batch(gait, starts, law=noisy)
    for _ in range(2):
        stepping.step()
    again = Batch(gait, starts[:1], law=noisy)
    again.resume(stepping.save(), 2)
    for batch in (stepping, again):
        for _ in range(2):
            fates = batch.step()
        np.testing.assert_array_equal(fates, found.fate)
        np.testing.assert_array_equal(batch.apices[closed], found.apex[closed])
    plain = Batch(gait, starts, law=noisy).run(4)
    np.testing.assert_array_equal(plain.fate, found.fate)
    assert plain.apex[closed] == pytest.approx(found.apex[closed], abs=1e-7)
