"""The benchmark measures what it says; how fast this machine is, is no matter of a test."""

import pytest
from tdmf_slip import bench, load


def test_both_solvers_are_measured_at_the_wanted_error():
    measured = bench.bench(effort=0.01)
    assert [m.solver for m in measured.measurements] == ["native", "cvode"]
    assert all(0 < m.error <= bench.WANTED_ERROR for m in measured.measurements)
    assert all(m.microseconds > 0 and m.evaluations > 100 for m in measured.measurements)
    assert "CVODE" in measured.as_text() and measured.as_json()["ratio"] == measured.ratio


@pytest.mark.parametrize("solver", ["native", "cvode"])
def test_a_tighter_tolerance_costs_more_and_errs_less(solver):
    loose = bench.stride_error(load(), solver, 1e-5)
    tight = bench.stride_error(load(), solver, 1e-10)
    assert tight[0] < loose[0]
    assert tight[1] > loose[1]
