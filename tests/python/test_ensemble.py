"""The ensemble engine as Python sees it."""

import numpy as np
import pytest
from tdmf_slip import InputError, Runner, find_gait
from tdmf_slip.analysis import fates, volume
from tdmf_slip.library import binding, ensemble


@pytest.fixture(scope="module")
def gaits():
    return [find_gait(Runner({"ground.friction": mu})) for mu in (0.6, 1.2)]


@pytest.fixture(scope="module")
def starts(gaits):
    rng = np.random.default_rng(5)
    return np.array([gaits[i % 2].apex + rng.uniform(-0.1, 0.1, 6) for i in range(200)])


def test_every_instruction_set_ends_alike(gaits, starts):
    cases = [ensemble.Case(Runner(g.runner)) for g in gaits]
    numbers = np.arange(len(starts)) % 2
    ends = {
        name: ensemble.run_ensemble(
            cases, starts, numbers, max_strides=3, tolerance=1e-11, instructions=name, threads=2
        )[0]
        for name in ensemble.instruction_sets()
    }
    native = ends.pop("one by one")
    assert ends
    assert (native["strides"] == 3).all()
    for found in ends.values():
        for name in ("fate", "strides", "word_code"):
            np.testing.assert_array_equal(found[name], native[name])
        for name in ("apex", "time", "distance", "work", "damper_loss", "friction_loss", "impact_loss"):
            np.testing.assert_allclose(found[name], native[name], rtol=1e-8, atol=1e-8)


CHANGED = ("leg.stiffness", "leg.damping", "hip.kp", "hip.kd", "gravity", "foot.mass", "hip.stance_torque")
FRICTIONS = (10.0, 1.2, 0.6, 0.43, 0.2)


def populations(unit, size):
    """Cases, starts and case numbers: around the published gaits, all over the box, and of other runners."""
    rng = np.random.default_rng(11)
    gaits = [find_gait(Runner({"ground.friction": mu})) for mu in FRICTIONS]
    cases = [ensemble.Case(Runner(gait.runner)) for gait in gaits]
    numbers = np.arange(size) % len(gaits)
    near = np.array([gaits[i].apex for i in numbers]) + rng.uniform(-0.05, 0.05, (size, 6))
    low, high = np.array(list(volume.BOX.values())).T
    yield "near", cases, near, numbers
    yield "box", cases, rng.uniform(low, high, (size, 6)), numbers
    others = []
    for factors in np.exp(rng.uniform(-1.0, 1.0, (size // 4, len(CHANGED)))):
        values = dict(gaits[2].runner)
        values |= {name: factor * values[name] for name, factor in zip(CHANGED, factors, strict=True)}
        values |= {"ground.friction": rng.uniform(0.1, 2.0), "hip.touchdown_angle": rng.uniform(0.3, 1.0)}
        others.append(ensemble.Case(Runner(values)))
    wild = gaits[2].apex + rng.uniform(-0.2, 0.2, (len(others), 6))
    yield "other runners", others, wild, np.arange(len(others))


def errors(cases, starts, numbers, tolerance, instructions):
    """The largest of each stride that closes: of apex, time, distance and energies, over their scales."""

    def run(tolerance, instructions):
        return ensemble.run_ensemble(
            cases, starts, numbers, max_strides=1, tolerance=tolerance, instructions=instructions, threads=2
        )[0]

    exact, found = run(1e-13, "one by one"), run(tolerance, instructions)
    np.testing.assert_array_equal(found["strides"], exact["strides"])
    np.testing.assert_array_equal(found["word_code"], exact["word_code"])
    scales = np.array([case.runner.scales for case in cases])[numbers]
    length, time = scales[:, 0], 1.0 / scales[:, 5]
    energy = np.array([case.runner["leg.stiffness"] for case in cases])[numbers] * length**2
    worst = np.max(np.abs(found["apex"] - exact["apex"]) / scales, axis=1)
    units = {"time": time, "distance": length, "work": energy, "damper_loss": energy}
    for name, scale in (units | {"friction_loss": energy, "impact_loss": energy}).items():
        worst = np.maximum(worst, np.abs(found[name] - exact[name]) / scale)
    return worst[exact["strides"] == 1]


@pytest.mark.parametrize("instructions", ensemble.instruction_sets())
def test_every_stride_keeps_the_promised_accuracy(fmu, instructions):
    """All of them, not most."""
    compared = 0
    for name, *population in populations(fmu, 2000):
        worst = errors(*population, ensemble.TOLERANCE, instructions)
        assert np.mean(worst <= ensemble.ACCURACY) == 1.0, f"{name}: {worst.max():.1e}"
        compared += len(worst)
    assert compared > 3500


def test_a_map_keeps_the_promised_accuracy(fmu):
    fastest = ensemble.instruction_sets()[-1]
    allowed = {"near": fates.ACCURACY / 20.0, "box": fates.ACCURACY}
    compared = 0
    for name, cases, starts, numbers in populations(fmu, 2000):
        if name not in allowed:
            continue
        scales = np.array([case.runner.scales for case in cases])[numbers]
        apices = [
            ensemble.run_ensemble(
                cases, starts, numbers, max_strides=1, tolerance=tolerance, instructions=kind, threads=2
            )[0]["apex"]
            for tolerance, kind in ((fates.TOLERANCE, fastest), (1e-13, "one by one"))
        ]
        assert np.max(np.abs(apices[0] - apices[1]) / scales) <= allowed[name], name
        compared += 1
    assert compared == len(allowed)


def test_runners_settle_on_their_own_gait(gaits, starts):
    """Two gaits are offered to each; a runner ends on that of its friction, whose apex it reaches."""
    apices = [g.apex for g in gaits]
    cases = [ensemble.Case(Runner(g.runner), apices) for g in gaits]
    numbers = np.arange(len(starts)) % 2
    ends, work = ensemble.run_ensemble(cases, starts, numbers, max_strides=400, near=1e-3)
    np.testing.assert_array_equal(ends["gait"], numbers)
    assert (ends["fate"] == ensemble.FATES.index("settled")).all()
    np.testing.assert_allclose(ends["apex"], np.array(apices)[numbers], atol=1e-3)
    assert work.strides == ends["strides"].sum()


def test_a_runner_too_stiff_has_not_fallen(gaits, starts):
    stiff = ensemble.Case(Runner({**gaits[0].runner, "hip.kd": 2.5e13}), [gaits[0].apex])
    ends, work = ensemble.run_ensemble([stiff], starts[:50], max_strides=400)
    assert (ends["fate"] == ensemble.FATES.index("unsolved")).all()
    assert work.steps <= 50


@pytest.mark.parametrize(
    "wrong",
    [
        {"tolerance": 0.0},
        {"tolerance": float("nan")},
        {"threads": -1},
        {"instructions": "mmx"},
        {"tolerance": 1e300},
        {"threads": 0.5},
        {"max_strides": 0},
        {"max_strides": 2.9},
        {"max_strides": 10**12},
        {"max_strides": float("nan")},
        {"near": -1.0},
        {"case_of": np.array([0, 1])},
        {"case_of": [0.7, 0.0]},
        {"case_of": [0, 2**32]},
        {"case_of": ["a", "b"]},
        {"tolerance": 1e-300},
        {"starts": np.zeros((2, 6), dtype=complex)},
        {"starts": np.zeros((2, 5))},
    ],
)
def test_what_is_not_allowed_is_said(gaits, starts, wrong):
    arguments = {"starts": starts[:2], "max_strides": 1} | wrong
    with pytest.raises(InputError, match="allowed"):
        ensemble.run_ensemble([ensemble.Case(gaits[0].runner)], arguments.pop("starts"), **arguments)


def test_instructions_that_a_processor_has_not_are_refused(gaits, starts, monkeypatch):
    class Poor:
        """A processor without vector registers of its own."""

        def __getattr__(self, name):
            return getattr(binding.c, name)

        def tdmf_has_instructions(self, number):
            return number <= binding.c.TDMF_TWO_LANES

    monkeypatch.setattr(ensemble, "c", Poor())
    assert ensemble.instruction_sets() == ("one by one", "two lanes")
    with pytest.raises(InputError, match="'avx2': allowed here: one by one, two lanes"):
        ensemble.run_ensemble(
            [ensemble.Case(gaits[0].runner)], starts[:2], max_strides=1, instructions="avx2", threads=1
        )


@pytest.mark.parametrize("wrong", [[[1.0] * 5], [[1.0] * 7], [[float("nan")] * 6], [3.0]])
def test_what_is_no_gait_is_said(gaits, starts, wrong):
    with pytest.raises(InputError, match="gaits"):
        ensemble.run_ensemble([ensemble.Case(gaits[0].runner, wrong)], starts[:2], max_strides=1)


def test_no_case_is_none(starts):
    with pytest.raises(InputError, match="cases"):
        ensemble.run_ensemble([], starts[:2], max_strides=1)
