"""What must hold over many strides: no chatter, a closed ledger, a foot above the ground, bounded memory."""

import numpy as np
import pytest
from conftest import RELEASE, apex_start, reference_gaits, runner_of_gait, some_of, unit_reference
from tdmf_slip import InputError, Profile, RunError
from tdmf_slip.fmu import instance
from tdmf_slip.fmu.simulation import run_unit

PERIOD = unit_reference()["period"]
LEDGER = (
    "energy.total",
    "hip.work",
    "hip.positive_work",
    "energy.damper_loss",
    "energy.friction_loss",
    "energy.impact_loss",
)


def test_many_strides_without_chatter(run):
    """200 of them, or with --release 2000."""
    count = 2000 if RELEASE else 200
    rows, instance = run(
        (count + 0.5) * PERIOD,
        {},
        tolerance=1e-6,
        output_interval=8.0,
        output=("stride.count", "event.count", "foot.y"),
    )
    strides, first = np.unique(rows["stride.count"], return_index=True)
    assert strides[-1] == count
    assert set(np.diff(rows["event.count"][first])) == {9}
    assert rows["foot.y"].min() > -1e-9
    assert instance.text("stride.word") == "+0-0+"


def test_ledger_closes_over_a_hundred_strides(run):
    """One published gait is run, with --release all of both readings."""
    for gait in some_of(reference_gaits(), 1):
        start = apex_start(gait["apex"]) | runner_of_gait(gait)
        rows, _ = run(100.2 * gait["period"], start, output=LEDGER, output_interval=2.0)
        change = rows["energy.total"] - rows["energy.total"][0]
        losses = [rows[name] for name in LEDGER[3:]]
        gap = change - rows["hip.work"] + sum(losses)
        assert np.abs(gap).max() < 1e-5 * rows["hip.positive_work"][-1], gait["friction"]
        assert all(np.diff(loss).min() >= -1e-12 and loss[-1] > 0 for loss in losses)


def test_center_of_mass_is_ballistic_in_flight(run):
    """CVODE's own error is up to some 200 tolerances."""
    output = ("com.vx", "com.vy", "contact.mode_index", "event.count")
    rows, _ = run(3 * PERIOD, {}, tolerance=1e-11, output=output)
    off_ground = np.isin(rows["contact.mode_index"], (1, 5))
    for event in np.unique(rows["event.count"]):
        phase = rows[off_ground & (rows["event.count"] == event)]
        if len(phase) > 1:
            assert np.ptp(phase["com.vx"]) < 1e-8
            assert np.ptp(phase["com.vy"] + 0.01 * phase["time"]) < 1e-8


@pytest.mark.parametrize(
    "given",
    [{}, {"interface": "cs"}, {"profile": Profile.random_steps(count=3, tread=7.0, roughness=0.01, seed=1)}],
)
def test_a_run_keeps_no_more_numbers_than_it_may(monkeypatch, given):
    """Rows at events count, too: five columns are recorded, the time and what is needed inside among them."""
    monkeypatch.setattr(instance, "MAX_NUMBERS", 5 * 250)
    kept = {"stop_time": 20.0, "output_interval": 0.1, "variables": ["com.x"], **given}
    assert len(run_unit(**kept).table) <= 250
    with pytest.raises(RunError, match=r"250 rows of 5 columns by t = .* fewer variables"):
        run_unit(**{**kept, "stop_time": None, "strides": 3})
    with pytest.raises(InputError, match=r"allowed: 250 rows of 5 columns"):
        run_unit(**{**kept, "stop_time": 50.0})
