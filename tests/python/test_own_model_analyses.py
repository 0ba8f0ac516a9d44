"""Analyses of models of users' own: a page that is the package's runner gives what the runner gives."""

import numpy as np
import pytest
import tdmf_slip
from conftest import ROOT
from own_pages import loaded
from page_runs import COMPILER
from tdmf_slip import Batch, InputError, Runner, basin, continue_branch, find_gait, gait_at, lqr, sweep

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")
NO_GAINS = {"hip.stance_kp": 0.0, "hip.stance_kd": 0.0}
AXES = {"com_height": (0.9, 2.4), "com_speed": (0.3, 1.8)}
SETTINGS = ["hip.touchdown_angle", "hip.stance_torque"]


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    return loaded(tdmf_slip.new(tmp_path_factory.mktemp("new") / "my_ball", start="scratch") / "page.py")


@pytest.fixture(scope="module")
def pd_runner():
    return loaded(ROOT / "examples" / "pages" / "pd_runner.py")


@pytest.fixture(scope="module")
def paper_s(pd_runner):
    """The paper's runner by a page of one's own."""
    return Runner(pd_runner, **NO_GAINS)


def test_many_strides_in_lanes_are_single_strides_bit_for_bit(pd_runner):
    starts = find_gait(pd_runner).apex + np.random.default_rng(1).uniform(-0.6, 0.6, (150, 6))
    kp = np.linspace(0.0, 0.1, 150)
    together = Batch(pd_runner, starts, vary={"stance_kp": kp}).stride(jacobian=True)
    assert len(set(together.word)) > 3 and np.count_nonzero(together.outcome == 0) > 50
    for k in (0, 3, 77, 149):
        one = Batch(Runner(pd_runner, stance_kp=kp[k]), starts[k]).stride(jacobian=True)
        np.testing.assert_array_equal(one.next_apex, together.next_apex[k])
        np.testing.assert_array_equal(one.jacobian, together.jacobian[k])
        assert one.word == together.word[k]


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


def test_settings_from_stride_to_stride_are_those_of_the_built_in_runner(paper_s):
    inputs = {"friction": [0.6, 0.5, 0.7], "hip.stance_torque": np.array([[0.2, 0.21, 0.19]])}
    apex = find_gait().apex
    mine, own = (Batch(runner, apex, inputs=inputs).run(3).apex for runner in (paper_s, {}))
    assert mine == pytest.approx(own, abs=1e-7)
    stepping = Batch(paper_s, apex)
    for k in range(3):
        stepping.step({name: np.ravel(values)[k] for name, values in inputs.items()})
    assert stepping.apices[0] == pytest.approx(own, abs=1e-7)


def test_an_optimum_is_that_of_the_built_in_runner(paper_s):
    vary = {"hip.stance_torque": (0.15, 0.25), "hip.touchdown_angle": (0.6, 0.75)}
    mine, own = (
        tdmf_slip.optimize(runner, vary, minimize="cost_of_transport", target={"speed": 1.0}, starts=1)
        for runner in (paper_s, None)
    )
    for name in vary:
        assert mine.parameters[name] == pytest.approx(own.parameters[name], abs=1e-6)


def test_a_target_and_a_branch_of_the_ball_are_those_of_the_closed_form(ball):
    """The speed after an impact is push/(1 - restitution), the period twice that over gravity."""
    gait = find_gait(ball, target={"period": 1.2}, vary=["push"])
    assert gait.runner["push"] == pytest.approx(1.2 / 2 * 9.81 * 0.2, rel=1e-9)
    branch = continue_branch(ball, {"restitution": (0.3, 0.9)})
    values = branch["restitution"].values
    assert branch["apex_height"].values == pytest.approx((1 / (1 - values)) ** 2 / 2 / 9.81, rel=1e-9)
    assert branch["lambda_max"].values == pytest.approx(values, abs=1e-9)


def test_a_simulation_of_the_ball_is_its_parabolas(ball):
    run = tdmf_slip.simulate(Runner(ball, push=0.0, height=2.0), stop_time=1.5, output_interval=0.01)
    times, falls = run["time"].values, np.sqrt(4 / 9.81)
    flight = times < falls
    assert run["height"].values[flight] == pytest.approx(2 - 9.81 / 2 * times[flight] ** 2, abs=1e-11)
    after = (times > falls) & (times < falls + 1.5 * falls)
    since, speed = times[after] - falls, 0.8 * 9.81 * falls
    assert run["height"].values[after] == pytest.approx(speed * since - 9.81 / 2 * since**2, abs=1e-11)
    assert run["energy"].values[flight] == pytest.approx(9.81 * 2, abs=1e-10)
    assert run["energy"].values[after] == pytest.approx(0.64 * 9.81 * 2, abs=1e-10)


def test_a_trajectory_of_the_paper_s_runner_is_that_of_the_engine(paper_s):
    gait = find_gait(paper_s)
    times = np.linspace(0, 0.99 * gait.period, 60)
    mine, own = (tdmf_slip.trajectory(runner, gait.apex, times=times) for runner in (paper_s, None))
    for name in ("com.y", "foot.y", "leg.angle", "hip.torque", "energy.total"):
        assert mine[name].values == pytest.approx(own[name].values, abs=1e-8), name


def test_what_needs_the_package_s_own_models_says_so(pd_runner, ball):
    vary = {"hip.touchdown_angle": (0.3, 1.1, 3)}
    with pytest.raises(InputError, match="viability needs a model of the package itself; allowed for it"):
        tdmf_slip.viability(pd_runner, axes=AXES, vary=vary)
    with pytest.raises(InputError, match="needs a model of the package itself; allowed for it"):
        tdmf_slip.prove(pd_runner)
    with pytest.raises(InputError, match="by the model pd_runner; allowed: by the full model"):
        tdmf_slip.strides_to_fall(pd_runner, 0.3, 10, 1, 5)
    with pytest.raises(InputError, match=r"stiffness.* is neither an argument nor a variable"):
        find_gait(ball, stiffness=1)
    with pytest.raises(InputError, match="push cannot change in a run; allowed: none; a page declares"):
        Batch(ball, [1.0], inputs={"push": 2.0})


@pytest.mark.parametrize("draw", ["gait", "branch", "sweep"])
def test_pictures_of_models_of_one_s_own_are_drawn(pd_runner, draw):
    pytest.importorskip("matplotlib")
    values = {"stance_kp": [0.0, 0.01]}
    made = {
        "branch": lambda: continue_branch(pd_runner, {"stance_kp": (0.0, 0.01)}),
        "sweep": lambda: sweep(pd_runner, values).gaits,
        "gait": lambda: find_gait(pd_runner),
    }
    figure = tdmf_slip.plot(made[draw]())
    assert len(figure.axes) >= 2
