"""A library leaves its host alone: other users of FMPy, signal handlers, environment, Matplotlib backend."""

import signal
import subprocess
import sys

import fmpy.simulation
import fmpy.sundials
import numpy as np
import pytest
import tdmf_slip
from conftest import HANGS
from tdmf_slip.files.netcdf import write_dataset

TORQUE = {"hip.external_torque": ([1.0, 3.33, 7.77, 9.1], [0.0, 0.02, -0.01, 0.01])}


def own_run(unit):
    """A run of somebody who uses FMPy, with a ramp off FMPy's grid."""
    times, values = TORQUE["hip.external_torque"]
    ramp = np.array(
        list(zip(times, values, strict=True)), dtype=[("time", float), ("hip.external_torque", float)]
    )
    return fmpy.simulate_fmu(
        unit, input=ramp, stop_time=14.0, output=["foot.x", "leg.angle"], fmi_type="ModelExchange"
    )


def test_whoever_uses_fmpy_gets_the_same_before_and_after_a_run(unpacked, capsys):
    """The package follows inputs in another way than FMPy, in its own runs alone."""
    classes = fmpy.simulation.Input, fmpy.sundials.CVodeSolver, fmpy.simulate_fmu
    before = own_run(unpacked)
    followed = tdmf_slip.simulate(inputs=TORQUE, stop_time=14.0, variables=["leg.angle"])
    assert abs(followed["leg.angle"][-1] - before["leg.angle"][-1]) > 1e-9
    assert (own_run(unpacked) == before).all()
    assert (fmpy.simulation.Input, fmpy.sundials.CVodeSolver, fmpy.simulate_fmu) == classes


CALLS = {
    "a run": lambda _: tdmf_slip.simulate(strides=1),
    "many runs": lambda _: tdmf_slip.simulate_many([{}, {}], strides=1),
    "the engine": lambda _: tdmf_slip.strides_to_fall({}, 0.0, 1000, max_strides=1),
    "a file": lambda folder: write_dataset(folder / "run.nc", tdmf_slip.simulate(strides=1).to_xarray()),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_signal_handlers_stay_those_of_the_host(call, tmp_path, monkeypatch):
    def handle(number, handler):
        raise AssertionError(f"the handler of signal {number} is replaced")

    monkeypatch.setattr(signal, "signal", handle)
    call(tmp_path)


BASIN = "tdmf_slip.basin({}, {'com_height': (1.3, 1.4), 'com_speed': (1, 1.1)}, n=2)"


@pytest.mark.parametrize(
    ("look", "use"),
    [
        ("dict(__import__('os').environ)", "tdmf_slip.simulate(strides=1)"),
        ("__import__('matplotlib').rcParams._get('backend')", "tdmf_slip.simulate(strides=1).plot()"),
        ("__import__('threading').enumerate()", BASIN),
        ("vars(__import__('tqdm').tqdm).get('_lock')", BASIN),
    ],
    ids=["environment", "backend", "threads", "lock of tqdm"],
)
def test_settings_of_the_process_stay(look, use, tmp_path):
    program = f"import tdmf_slip\nbefore = {look}\n{use}\nassert {look} == before"
    environment = {"PATH": "", "MPLCONFIGDIR": str(tmp_path)}  # this process has used the package already
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=HANGS, env=environment
    )
    assert done.returncode == 0, done.stderr
