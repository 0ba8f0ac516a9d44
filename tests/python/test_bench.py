"""The benchmark measures what it says; how fast this machine is, is no matter of a test."""

import pytest
from tdmf_slip import bench, load


def test_all_solvers_are_measured_at_the_wanted_error():
    measured = bench.bench(effort=0.01)
    names = [m.solver.split()[0].rstrip(",") for m in measured.measurements]
    assert names == ["native", "cvode", "heyoka", "heyoka"]
    assert all(0 < m.error <= bench.WANTED_ERROR for m in measured.measurements)
    assert all(m.microseconds > 0 for m in measured.measurements)
    assert all(m.evaluations > 100 for m in measured.measurements[:2])
    assert set(measured.as_json()["ratios"]) == {m.solver for m in measured.measurements[1:]}
    assert "times as fast as cvode" in measured.as_text()


def test_a_peer_that_is_missing_is_named(monkeypatch):
    def missing(*_):
        raise ImportError

    monkeypatch.setattr(bench, "measure_heyoka", missing)
    measured = bench.bench(effort=0.01)
    assert measured.missing == ("heyoka",)
    assert "heyoka is not installed" in measured.as_text()


@pytest.mark.parametrize("solver", ["native", "cvode"])
def test_a_tighter_tolerance_errs_less(solver):
    assert bench.stride_error(load(), solver, 1e-10) < bench.stride_error(load(), solver, 1e-5)
