"""A batch: runs by the engine, one stride with derivatives, stepping, laws, and what is refused."""

import functools
import pickle

import numpy as np
import pytest
from tdmf_slip import AffineLaw, Batch, InputError, RoughGround, Runner, find_gait
from tdmf_slip.analysis import attraction, ball
from tdmf_slip.library import batch, binding, engine


@pytest.fixture(scope="module")
def gaits():
    return [find_gait(Runner({"ground.friction": mu})) for mu in (0.6, 1.2)]


@pytest.fixture(scope="module")
def starts(gaits):
    rng = np.random.default_rng(5)
    return np.array([gaits[i % 2].apex + rng.uniform(-0.1, 0.1, 6) for i in range(200)])


CHANGED = ("leg.stiffness", "leg.damping", "hip.kp", "hip.kd", "gravity", "foot.mass", "hip.stance_torque")
FRICTIONS = (10.0, 1.2, 0.6, 0.43, 0.2)


@functools.cache
def populations():
    """Runners, starts and exact strides: near published gaits, all over the box, and of other runners."""
    rng, size = np.random.default_rng(11), 1000
    gaits = [find_gait(Runner({"ground.friction": mu})) for mu in FRICTIONS]
    numbers = np.arange(size) % len(gaits)
    runners = [gaits[k].runner for k in numbers]
    low, high = np.array(list(attraction.BOX.values())).T
    others = []
    for factors in np.exp(rng.uniform(-1.0, 1.0, (size // 4, len(CHANGED)))):
        values = dict(gaits[2].runner)
        values |= {name: factor * values[name] for name, factor in zip(CHANGED, factors, strict=True)}
        values |= {"ground.friction": rng.uniform(0.1, 2.0), "hip.touchdown_angle": rng.uniform(0.3, 1.0)}
        others.append(Runner(values))
    found = {
        "near": (runners, np.array([gaits[i].apex for i in numbers]) + rng.uniform(-0.05, 0.05, (size, 6))),
        "box": (runners, rng.uniform(low, high, (size, 6))),
        "other runners": (others, gaits[2].apex + rng.uniform(-0.2, 0.2, (len(others), 6))),
    }
    return {name: (*given, stride(*given, 1e-13, "one by one")) for name, given in found.items()}


def stride(runners, starts, tolerance, instructions):
    return Batch(runners, starts, tolerance=tolerance, instructions=instructions, threads=2).run(1)


@pytest.mark.parametrize("instructions", engine.instruction_sets())
def test_every_stride_keeps_the_promised_accuracy(instructions):
    """All of them, not most: apex, time, distance and energies, over their scales."""
    for name, (runners, starts, exact) in populations().items():
        found = stride(runners, starts, batch.TOLERANCE, instructions)
        for of in ("fate", "strides", "word_code"):
            np.testing.assert_array_equal(found[of], exact[of])
        scales = np.array([runner.scales for runner in runners])
        length, time = scales[:, 0], 1.0 / scales[:, 5]
        energy = np.array([runner["leg.stiffness"] for runner in runners]) * length**2
        worst = np.max(np.abs(found["apex"] - exact["apex"]) / scales, axis=1)
        units = {"time": time, "distance": length, "work": energy, "damper_loss": energy}
        for of, scale in (units | {"friction_loss": energy, "impact_loss": energy}).items():
            worst = np.maximum(worst, np.abs(found[of] - exact[of]) / scale)
        closed = worst[exact["strides"] == 1]
        assert len(closed) > 0.5 * len(worst) and closed.max() <= batch.ACCURACY, name


def test_a_map_keeps_the_promised_accuracy():
    fastest = engine.instruction_sets()[-1]
    for name, allowed in {"near": ball.ACCURACY / 20.0, "box": ball.ACCURACY}.items():
        runners, starts, exact = populations()[name]
        off = stride(runners, starts, ball.TOLERANCE, fastest).apex - exact.apex
        assert np.max(np.abs(off) / [runner.scales for runner in runners]) <= allowed, name


def test_runners_settle_on_their_own_gait(gaits, starts):
    """Two gaits are offered to each; a runner ends on that of its friction, whose apex it reaches."""
    apices = [g.apex for g in gaits]
    numbers = np.arange(len(starts)) % 2
    ends = Batch([gaits[k].runner for k in numbers], starts).run(400, apices, near=1e-3)
    np.testing.assert_array_equal(ends["gait"], numbers)
    assert (ends["fate"] == engine.SETTLED).all()
    np.testing.assert_allclose(ends["apex"], np.array(apices)[numbers], atol=1e-3)
    assert ends.attributes["work_done"]["strides"] == ends["strides"].sum()


def test_a_runner_too_stiff_is_given_up_at_its_first_step(gaits, starts):
    ends = Batch(gaits[0].runner.replace({"hip.kd": 2.5e13}), starts[:50]).run(400, gaits[0])
    assert (ends.fate == engine.UNSOLVED).all()
    assert ends.attributes["work_done"]["steps"] <= 50


@pytest.mark.parametrize(
    "wrong",
    [
        {"tolerance": 0.0},
        {"tolerance": float("nan")},
        {"threads": -1},
        {"tolerance": 1e300},
        {"threads": 0.5},
        {"tolerance": 1e-300},
        {"step_limit": 0},
        {"first_number": -1},
        {"apices": np.zeros((2, 6), dtype=complex)},
        {"apices": np.zeros((3, 2, 6))},
        {"runners": []},
        {"runners": [{}, {}, {}]},
        {"runners": [None, {}], "vary": {"gravity": [1e-3, 2e-3]}},
        {"runners": {"gravity": [1e-3, 2e-3, 3e-3]}},
        {"ground": 0.1},
        {"law": "stiff"},
        {"law": lambda apices: {}},
        {"inputs": {"hip.touchdown_angle": np.zeros((2, 2, 2))}},
    ],
)
def test_a_batch_refuses_what_is_not_allowed(starts, wrong):
    with pytest.raises(InputError, match=r"allowed|it must be"):
        Batch(**{"runners": None, "apices": starts[:2]} | wrong)


@pytest.mark.parametrize(
    "wrong",
    [
        {"strides": 0},
        {"strides": 2.9},
        {"strides": 10**12},
        {"strides": float("nan")},
        {"until": [[1.0] * 5]},
        {"until": [[1.0] * 7]},
        {"until": [[float("nan")] * 6]},
        {"until": [3.0]},
        {"until": np.ones((3, 1, 6))},
        {"until": [1.0] * 6, "near": -1.0},
        {"until": [1.0] * 6, "balls": np.zeros((2, 6, 6))},
        {"until": [1.0] * 6, "balls": np.full((1, 6, 6), np.nan)},
        {"until": [1.0] * 6, "balls": [[1.0], [1.0, 2.0]]},
        {"balls": np.zeros((1, 6, 6))},
    ],
)
def test_a_run_refuses_what_is_not_allowed(starts, wrong):
    with pytest.raises(InputError, match="allowed"):
        Batch(None, starts[:2]).run(**{"strides": 1} | wrong)


def test_instructions_that_a_processor_has_not_are_refused(gaits, starts, monkeypatch):
    class Poor:
        """A processor without vector registers of its own."""

        def __getattr__(self, name):
            return getattr(binding.c, name)

        def tdmf_has_instructions(self, number):
            return number <= binding.c.TDMF_TWO_LANES

    monkeypatch.setattr(engine, "c", Poor())
    assert engine.instruction_sets() == ("one by one", "two lanes")
    with pytest.raises(InputError, match="'avx2': allowed here: one by one, two lanes"):
        Batch(gaits[0], starts[:2], instructions="avx2", threads=1)


# ---- one stride, stepping, states -------------------------------------------------------------------------


def test_a_stride_has_the_derivatives_of_differences(gaits):
    """The derivatives are by more names than one call of the library takes, and along a direction."""
    gait, names = gaits[0], ["leg.stiffness", "leg.damping", "foot.mass", "gravity", "hip.kp", "hip.kd"]
    names += ["hip.stance_torque", "hip.touchdown_angle", "ground.friction", "leg.free_length"]
    along = {"leg.stiffness": 2.0, "ground.friction": 0.5}
    made = Batch(gait, gait.apex).stride(along=[*names, along])
    assert made.next_apex == pytest.approx(gait.apex, abs=1e-10)
    np.testing.assert_array_equal(made.jacobian, made.next_apex_by[:, :6])
    assert made.jacobian == pytest.approx(gait.jacobian, abs=1e-8)
    quantities = (
        "period",
        "speed",
        "duty_factor",
        "cost_of_transport",
        "positive_cost_of_transport",
        "frequency",
    )
    for number, name in enumerate(names):
        h = 1e-6 * max(abs(gait.runner[name]), 1e-3)
        up, down = (
            Batch(gait.runner.replace({name: gait.runner[name] + step}), gait.apex).stride()
            for step in (h, -h)
        )
        difference = (up.next_apex - down.next_apex) / (2.0 * h)
        assert made.next_apex_by[:, 6 + number] == pytest.approx(difference, rel=1e-5, abs=1e-6), name
        for of in quantities:
            difference = (up[of] - down[of]) / (2.0 * h)
            assert made[f"{of}_by"][6 + number] == pytest.approx(difference, rel=1e-5, abs=1e-6), (name, of)
    sums = 2.0 * made.next_apex_by[:, 6] + 0.5 * made.next_apex_by[:, 6 + names.index("ground.friction")]
    assert made.next_apex_by[:, -1] == pytest.approx(sums, rel=1e-9, abs=1e-12)


def test_strides_that_do_not_close_are_not_numbers_and_say_why(gaits):
    apices = np.array([gaits[0].apex, gaits[0].apex * [0.1, 1, 1, 1, 1, 1]])
    made = Batch(gaits[0], apices).stride(jacobian=True)
    assert made.outcome[0] == 0 < made.outcome[1]
    for name in ("next_apex", "speed", "greatest_foot_height", "jacobian", "speed_by"):
        assert np.isfinite(made[name][0]).all() and np.isnan(made[name][1]).all(), name
    data = made.to_dataset()
    assert data["speed"].attrs["units"] == "m/s" and data["next_apex_by"].dims == (
        "runner",
        "coordinate",
        "by",
    )


def test_runners_of_a_batch_make_the_strides_of_each_alone(gaits):
    """Each runner has its own values, given as arrays, as a list of runners, and by `vary`."""
    friction, damping = [0.5, 0.6, 0.8], [0.19, 0.2, 0.21]
    values = {"ground.friction": friction, "leg.damping": damping}
    runners = [
        Runner({"ground.friction": f, "leg.damping": d}) for f, d in zip(friction, damping, strict=True)
    ]
    apex = gaits[0].apex
    made = Batch(values, apex).stride(along=["gravity"])
    for many in (Batch(runners, apex), Batch(None, apex, vary=values)):
        again = many.stride(along=["gravity"])
        for name in made:
            np.testing.assert_array_equal(again[name], made[name], err_msg=name)
    for number, runner in enumerate(runners):
        alone = Batch(runner, apex).stride(along=["gravity"])
        for name in made:
            np.testing.assert_array_equal(made[name][number], alone[name], err_msg=name)


def test_steps_in_place_are_strides_of_a_run(gaits, starts):
    """One runner and many are stepped with settings. Steps after the last setting change nothing."""
    angles = np.random.default_rng(3).uniform(0.6, 0.8, (50, 5))
    for apices, inputs in ((starts[:50], angles), (starts[0], angles[:1])):
        run = Batch(gaits[0], apices, inputs={"hip.touchdown_angle": inputs}).run(5, record=True)
        batch = Batch(gaits[0], apices)
        for stride in range(5):
            fates = batch.step({"hip.touchdown_angle": inputs[:, stride]})
            up = run.recorded.fate[:, stride] == 0
            np.testing.assert_array_equal(batch.apices[up], run.recorded.next_apex[up, stride])
            np.testing.assert_array_equal(batch.last["stride"]["speed"][up], run.recorded.speed[up, stride])
        np.testing.assert_array_equal(fates, np.atleast_1d(run.fate))


def test_saved_states_go_on_where_they_were(gaits, starts):
    """Copied, in any order and more of them than before, also through a pickle."""
    law = AffineLaw(["hip.stance_torque"], gaits[0].apex, [0.2], [[0.01] * 6], [0.1], [0.3])
    batch = Batch(gaits[0], starts[:20], RoughGround(0.1, 3), law)
    for _ in range(3):
        batch.step()
    saved = pickle.loads(pickle.dumps(batch.save()))
    again = Batch(gaits[0], starts[:1], RoughGround(0.1, 3), law)
    again.resume(saved, 3)
    np.testing.assert_array_equal(again.step(), batch.step())
    np.testing.assert_array_equal(again.apices, batch.apices)
    again.resume(np.concatenate([saved, saved])[::-1], 3)
    assert len(again.step()) == len(again) == 40


def test_parts_of_a_batch_are_its_runners_also_in_another_process(gaits, starts):
    ground, friction = RoughGround(0.2, 7), np.linspace(0.4, 0.8, len(starts))
    law = AffineLaw(["hip.stance_torque"], gaits[0].apex, [0.2], [[0.01] * 6], [0.1], [0.3], [0.02] * 6)
    batch = Batch(gaits[0].runner, starts, ground, law, vary={"ground.friction": friction})
    whole = batch.run(6)
    batch.step()  # what is under way stays here
    parts = [batch.part(first, 60) for first in range(0, len(starts), 60)]
    runs = [pickle.loads(pickle.dumps(part)).run(6) for part in parts]
    for name in whole:
        np.testing.assert_array_equal(np.concatenate([run[name] for run in runs]), whole[name], err_msg=name)


def test_each_gait_of_a_batch_begins_at_its_own_apex(gaits):
    np.testing.assert_array_equal(Batch(gaits).apices, [gait.apex for gait in gaits])
    runners = [Runner(), Runner({"foot.vx": 1.2})]
    np.testing.assert_array_equal(Batch(runners).apices, [runner.start_apex() for runner in runners])


def test_directions_have_short_names_and_what_is_no_direction_is_refused(gaits):
    batch = Batch(gaits[0])
    by_name = batch.stride(along=["ground.friction"]).next_apex_by
    np.testing.assert_array_equal(by_name, batch.stride(along=["friction"]).next_apex_by)
    np.testing.assert_array_equal(by_name, batch.stride(along=[{"friction": 1.0}]).next_apex_by)
    for wrong in ("friction", None, [3], [{"friction": np.nan}], [{"friction": "x"}]):
        with pytest.raises(InputError, match="along"):
            batch.stride(along=wrong)


def test_stepping_refuses_other_settings_than_the_first_and_states_before_a_stride(gaits):
    batch = Batch(gaits[0])
    for early in (batch.save, lambda: batch.last):
        with pytest.raises(InputError, match="no stride"):
            early()
    batch.step({"touchdown_angle": 0.7})
    with pytest.raises(InputError, match="as in the first call"):
        batch.step({"friction": 0.7})


def test_saved_states_are_resumed_by_a_batch_with_fewer_feet(gaits):
    batch = Batch(gaits[0], [gaits[0].apex] * 2, foot_x=[0.0, 1.0])
    batch.step()
    states = np.repeat(batch.save(), 40)
    expected = np.repeat(batch.save()["end"]["foot_x"], 40)
    batch.resume(states, 1)
    batch.step()
    np.testing.assert_allclose(np.diff(batch.save()["end"]["foot_x"] - expected), 0.0, atol=1e-8)
