"""The benchmark measures what it says; how fast this machine is, is no matter of a test."""

import json

import numpy as np
import pytest
from tdmf_slip import bench, ensemble, load

PEERS = ("native", "cvode", "heyoka", "numba", "scipy")


@pytest.fixture(scope="module")
def measured():
    return bench.bench(effort=0.01)


def test_all_solvers_are_measured_at_both_accuracies(measured):
    for accuracy in bench.ACCURACIES:
        rows = [m for m in measured.measurements if m.accuracy == accuracy]
        one = [m.solver.split()[0] for m in rows if m.group == bench.ONE and bench.ALONE not in m.solver]
        many = [m.solver for m in rows if m.group == bench.MANY]
        assert tuple(one) == PEERS
        assert (
            set(ensemble.instruction_sets()) < set(many) and len(many) == len(ensemble.instruction_sets()) + 2
        )
        assert all(0 < m.error <= accuracy and m.microseconds > 0 for m in rows)
    assert all(m.evaluations is None or m.evaluations > 100 for m in measured.measurements)


def test_ratios_are_to_our_own(measured):
    ours = [m for m in measured.measurements if m.solver == measured.ours[m.group]]
    assert len(ours) == len(measured.ours) * len(bench.ACCURACIES)
    assert [measured.ratio(m) for m in ours] == [1.0] * len(ours)
    text = measured.as_text()
    assert all(name in text for name in (*PEERS, "compiler: ", "integrators alone", "threads"))
    assert json.loads(json.dumps(measured.as_json()))["measurements"][0]["ratio"] > 0


def test_a_peer_that_is_missing_is_named(monkeypatch):
    def missing(*_):
        raise ImportError

    monkeypatch.setattr(bench, "measure_peer", missing)
    monkeypatch.setattr(bench, "measure_batches", missing)
    without = bench.bench(effort=0.01)
    assert without.missing == ("heyoka", "numba", "scipy")
    assert "numba is not installed" in without.as_text()


@pytest.mark.parametrize("solver", ["native", "cvode"])
def test_a_tighter_tolerance_errs_less(solver):
    assert bench.stride_error(load(), solver, 1e-10) < bench.stride_error(load(), solver, 1e-5)


def test_the_ensemble_makes_the_gaits_word(unit):
    """Peers are told the sequence of modes; it has to be that of every start."""
    many = bench.crowd(unit)
    ends, _ = ensemble.run([many.case], many.starts, most_strides=1)
    assert len(np.unique(ends["word_code"])) == 1 and (ends["strides"] == 1).all()


def test_bench_command(command):
    status, out, _ = command("bench", "--effort", 0.01, "--json")
    assert status == 0 and json.loads(out)["threads"] >= 1
    assert command("bench", "--effort", 0)[0] == 2
