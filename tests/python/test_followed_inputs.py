"""Inputs and tunable parameters that change in a run: ramps and steps, the same through both interfaces."""

import numpy as np
import pytest
from tdmf_slip.errors import InputError
from tdmf_slip.fmu.inputs import read_tables
from tdmf_slip.fmu.simulation import run_unit

RECORDED = ("leg.angle", "foot.x", "energy.total", "event.count", "hip.touchdown_angle", "control.thrust")
TABLES = {
    "a ramp with kinks off the grid": {
        "hip.external_torque": ([1.0, 3.33, 7.77, 9.1], [0.0, 0.02, -0.01, 0.01])
    },
    "a ramp that jumps": {"hip.external_torque": ([0.0, 5.55, 5.55, 12.0], [0.0, 0.02, -0.01, 0.0])},
    "steps of a discrete input": {"control.touchdown_angle": ([0.0, 4.44, 14.0], [0.01, 0.03, -0.01])},
    "steps of a tunable parameter": {"hip.kp": ([2.0, 6.66], [0.1, 0.13])},
}


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_both_interfaces_follow_it(table):
    """Up to the end of the second stance; without the table the run is another."""
    runs = [
        run_unit(inputs=inputs, variables=RECORDED, stop_time=14.5, interface=interface, tolerance=1e-11)
        for interface, inputs in (("me", table), ("cs", table), ("cs", {}))
    ]
    last, expected, without = (run.table[-1] for run in runs)
    assert last["event.count"] == expected["event.count"]
    for name in RECORDED[:3]:
        assert last[name] == pytest.approx(expected[name], rel=1e-7), name
    assert abs(without["leg.angle"] - expected["leg.angle"]) > 1e-4
    assert not runs[0].messages and not runs[1].messages


def test_a_discrete_input_keeps_a_value_until_the_next(tmp_path, fmu):
    file = tmp_path / "inputs.csv"
    file.write_text("time,control.thrust,hip.touchdown_angle\n0,0,40 deg\n2,0.1,41 deg\n3,0.2,41 deg\n")
    run = run_unit(inputs=read_tables(file, fmu), variables=RECORDED, stop_time=4.0, output_interval=0.5)
    table = run.table
    for begin, end, thrust, angle in ((0.0, 2.0, 0.0, 40.0), (2.0, 3.0, 0.1, 41.0), (3.0, 4.0, 0.2, 41.0)):
        inside = (table["time"] > begin) & (table["time"] < end)
        assert np.sum(inside) >= 1
        assert np.all(table["control.thrust"][inside] == thrust)
        assert np.degrees(table["hip.touchdown_angle"][inside]) == pytest.approx(angle)


def test_a_table_of_a_fixed_parameter_is_refused():
    with pytest.raises(InputError, match=r"body\.mass is neither an input nor tunable"):
        run_unit(inputs={"body.mass": ([0.0, 1.0], [1.0, 2.0])}, stop_time=1.0)
