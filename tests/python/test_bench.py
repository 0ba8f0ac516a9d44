"""The benchmark measures what it says; how fast this machine is, is no matter of a test."""

import json

import numpy as np
import pytest
from conftest import RELEASE, ROOT
from tdmf_slip import RunError
from tdmf_slip.library import engine

from benchmarks import growth, one_runner, results, runners, running

OURS = ("native", "cvode")
PEERS = ("heyoka", "numba", "scipy")


def missing(*_):
    """Stands for what asks a peer that is not installed."""
    raise ImportError


@pytest.fixture(scope="module")
def without_peers():
    """A benchmark where no peer is installed; judged by fewer starts than users have, which is faster."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(runners, "JUDGED", 16)
        patch.setattr(running, "measure_peer", missing)
        patch.setattr(running, "measure_batches", missing)
        patch.setattr(running, "check_agreement", lambda *_: None)
        return running.bench(effort=0.01)


@pytest.fixture(scope="module")
def measured(without_peers):
    """A benchmark; with its peers before a release only, because they compile themselves first."""
    if not RELEASE:
        return without_peers
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(runners, "JUDGED", 16)
        return running.bench(effort=0.01)


def test_all_solvers_are_measured_at_both_accuracies(measured):
    for accuracy in results.ACCURACIES:
        rows = [m for m in measured.measurements if m.accuracy == accuracy]
        alone = [m.solver for m in rows if m.group == results.ONE]
        assert alone.count(results.MOTION) == 1
        one = [name.split()[0] for name in alone if results.ALONE not in name and name != results.MOTION]
        many = [m.solver for m in rows if m.group == results.MANY]
        assert tuple(one) == (OURS + PEERS if RELEASE else OURS)
        sets = engine.instruction_sets()
        assert set(sets) <= set(many) and len(many) == len(sets) + (2 if RELEASE else 0)
        reduced = [m.solver for m in rows if m.group == results.REDUCED]
        assert reduced == [engine.instruction_sets()[-1], "one by one"]
        assert all(0 < m.error <= accuracy and m.microseconds > 0 for m in rows)
    assert all(m.evaluations is None or m.evaluations > 50 for m in measured.measurements)


def test_ratios_are_to_our_own(measured):
    ours = [m for m in measured.measurements if m.solver == measured.ours[m.group]]
    assert len(ours) == len(measured.ours) * len(results.ACCURACIES)
    assert [measured.ratio(m) for m in ours] == [1.0] * len(ours)
    text = measured.as_text()
    assert all(name in text for name in (*OURS, *PEERS, "compiler: ", "threads"))
    assert ("integrators alone" in text) is RELEASE
    printed = json.loads(json.dumps(measured.as_json()))
    assert printed["measurements"][0]["ratio"] > 0 and printed["runner"]["ground.friction"] == 0.6
    clamp = str(printed["runner"]["hip.swing_clamp"]).lower()
    assert text.endswith(f"hip.swing_clamp: {clamp}")
    assert RELEASE or (measured.missing == PEERS and "numba is not installed" in text)


def test_solvers_are_judged_by_the_gait_and_what_is_around_it():
    many = runners.runners_about_the_gait()
    apex, others = many.judged[0], many.judged[1:]
    assert len(others) == 64
    np.testing.assert_array_equal(apex, many.gait.apex)
    away = np.abs(others - apex)
    assert away.max() <= 0.05 and (away.max(axis=0) > 0.04).all()
    spoiled = many.exact["apex"].copy()
    assert many.error(spoiled) == 0.0
    spoiled[-1, 0] = np.nan
    assert many.error(spoiled) == np.inf


def test_nothing_is_timed_unless_all_solvers_agree(fmu, monkeypatch):
    """SciPy is given the other reading of the clamp, and disagrees."""
    from benchmarks.peers import scipy_peer

    honest, timed = scipy_peer.Peer.__init__, []
    monkeypatch.setattr(runners, "JUDGED", 2)
    monkeypatch.setattr(running, "PEERS", ("scipy",))
    monkeypatch.setattr(running, "measure_fmu", lambda *given: timed.append(given))
    monkeypatch.setattr(running, "batch_error", lambda *_: 0.0)
    running.check_agreement(fmu)
    for clamp in (False, True):

        def told_one_reading(peer, tolerance, _swing_clamp, clamp=clamp):
            honest(peer, tolerance, clamp)

        monkeypatch.setattr(scipy_peer.Peer, "__init__", told_one_reading)
        other = str(not clamp).lower()
        with pytest.raises(RunError, match=f"scipy, hip.swing_clamp = {other}: differs by"):
            running.bench(effort=0.01, fmu=fmu)
    assert not timed


def test_a_tolerance_that_is_found_is_good_from_everywhere(fmu):
    """The gait itself asks for less than its neighbours do."""
    many = runners.runners_about_the_gait()
    for found in one_runner.measure_fmu(fmu, many, "native", 0.01):
        assert found.error == one_runner.stride_error(fmu, many, "native", found.tolerance) <= found.accuracy
        assert many.error(many.ends("one by one", found.tolerance)["apex"]) <= found.accuracy


def test_bench_command(command, measured, monkeypatch):
    asked = []

    def remembered(*, effort, swing_clamp, progress):
        asked.append((effort, swing_clamp, progress))
        return measured

    status, out, err = command("bench")  # in an empty folder
    assert status == 2 and not out and "not in a checkout" in err
    monkeypatch.chdir(ROOT / "tests")
    assert command("bench", "--effort", 0)[0] == 2
    monkeypatch.setattr(running, "bench", remembered)
    status, out, _ = command("bench", "--effort", 0.01, "--json")
    assert status == 0 and json.loads(out)["threads"] >= 1
    assert command("bench", "--effort", 0.02, "--no-swing-clamp")[1].startswith(
        "one runner, to 1e-08; ratios to native"
    )
    assert asked == [(0.01, None, True), (0.02, False, True)]


def test_growth_times_each_question_by_its_size(command, monkeypatch):
    """All but the searches for an optimum, which take long at any effort, are really asked."""
    asked = []
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr(growth, "optimize", lambda *_, **given: asked.append(given["minimize"]))
    found = command.json("bench", "--growth", "--effort", 1e-4)
    assert asked == ["cost_of_transport"] * 2
    assert {row["question"] for row in found["timings"]} == {
        *("basin", "ensemble", "optimize", "fit", "continue"),
    }
    assert len({(row["question"], row["size"], row["threads"]) for row in found["timings"]}) == len(
        found["timings"]
    )
    assert all(row["seconds"] > 0 and row["processor_seconds"] > 0 for row in found["timings"])
    assert "processor" in found["versions"]
