"""Inputs that change in mid-run, and runs that end in a fall."""

import numpy as np
import pytest

STICK, SLIP_NEGATIVE = 2, 4
MODE = ("contact.mode_index", "foot.vx")


def friction_steps(*steps):
    """An input table with friction constant between (time, value) steps."""
    rows = [(0.0, steps[0][1])]
    for (time, value), (_, before) in zip(steps[1:], steps[:-1], strict=True):
        rows += [(time, before), (time, value)]
    rows.append((1e3, steps[-1][1]))
    return np.array(
        [(time, value, 0.0) for time, value in rows],
        dtype=[("time", float), ("ground.friction", float), ("hip.external_torque", float)],
    )


def test_ice_under_a_sticking_foot_makes_it_slip_at_once(run):
    """At friction 10 the foot sticks from touchdown at 11.9 on; the ice comes at 12.1."""
    inputs = friction_steps((0.0, 10.0), (12.1, 0.05))
    rows, _ = run(12.3, {}, output=MODE, inputs=inputs, output_interval=0.1)
    before = rows["contact.mode_index"][rows["time"] < 12.1]
    after = rows["contact.mode_index"][rows["time"] > 12.1 + 1e-9]
    assert before[-1] == STICK
    assert set(after) == {SLIP_NEGATIVE}


# A vertical drop from high above onto a leg that cannot take it.
DROP = {
    "hip.touchdown_angle": 0.0,
    "hip.stance_torque": 0.0,
    "leg.damping": 0.0,
    "leg.length": 1.0,
    "foot.y": 80.0,
    **dict.fromkeys(("leg.angle", "foot.vx", "foot.vy", "leg.length_rate", "leg.angle_rate"), 0.0),
}


def test_a_fall_ends_the_run_and_is_read_from_the_instance(run):
    rows, instance = run(200.0, DROP, output=MODE)
    assert instance.boolean("status.fallen")
    assert instance.real("leg.length")[0] == pytest.approx(0.05)
    assert 126.0 < rows["time"][-1] < 128.0


def test_a_fallen_run_may_go_on_frozen(run):
    rows, instance = run(200.0, DROP | {"status.terminate_on_fall": False}, output=("leg.length", "body.y"))
    assert instance.boolean("status.fallen")
    assert rows["time"][-1] == pytest.approx(200.0)
    fallen = rows[rows["time"] > 140.0]
    assert np.ptp(fallen["leg.length"]) == 0 and np.ptp(fallen["body.y"]) == 0


def test_external_torque_does_work_and_the_ledger_still_closes(run):
    inputs = np.array(
        [(0.0, 0.6, 0.01), (100.0, 0.6, 0.01)],
        dtype=[("time", float), ("ground.friction", float), ("hip.external_torque", float)],
    )
    losses = ("energy.damper_loss", "energy.friction_loss", "energy.impact_loss")
    names = ("energy.total", "hip.work", "hip.positive_work", *losses)
    rows, _ = run(60.0, {"hip.external_torque": 0.01}, output=names, inputs=inputs)
    first, last = rows[0], rows[-1]
    change = last["energy.total"] - first["energy.total"]
    turned_over = last["hip.positive_work"]
    assert turned_over > 0.1
    assert change == pytest.approx(
        last["hip.work"] - sum(last[name] for name in losses), abs=1e-5 * turned_over
    )
