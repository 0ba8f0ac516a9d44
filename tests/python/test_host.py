"""A library leaves its host alone: other users of FMPy, signal handlers, threads, settings of libraries."""

import sys

import fmpy.simulation
import fmpy.sundials
import numpy as np
import pytest
import tdmf_slip
from conftest import run_python

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


LOOK = """
import decimal, locale, os, random, signal, sys, threading, warnings
import fmpy, fmpy.fmi2, fmpy.simulation, fmpy.sundials, fmpy.sundials.cvode, fmpy.validation
import dask.array, distributed, matplotlib.figure, netCDF4, numpy, scipy.optimize, tqdm, xarray

FMPY = {name: module for name, module in sys.modules.items() if name.split(".")[0] == "fmpy"}

def attributes():
    found = {}
    for name, module in FMPY.items():
        for attribute, value in vars(module).items():
            found[name, attribute] = value
            if isinstance(value, type):
                found |= {(name, attribute, member): of for member, of in vars(value).items()}
    return found

def look():
    return {
        "signal handlers": {number: signal.getsignal(number) for number in signal.valid_signals()},
        "blocked signals": signal.pthread_sigmask(signal.SIG_BLOCK, ()),
        "FMPy": attributes(),
        "rcParams": {name: matplotlib.rcParams._get(name) for name in matplotlib.rcParams},
        "NumPy's error state": (numpy.geterr(), numpy.geterrcall()),
        "NumPy's print options": numpy.get_printoptions(),
        "NumPy's random state": repr(numpy.random.get_state()),
        "random state": random.getstate(),
        "decimal context": repr(decimal.getcontext()),
        "locale": locale.setlocale(locale.LC_ALL),
        "environment": dict(os.environ),
        "working directory": os.getcwd(),
        "threads": threading.enumerate(),
        "warning filters": list(warnings.filters),
        "hooks": (sys.excepthook, threading.excepthook, sys.displayhook, list(sys.path), list(sys.meta_path)),
        "streams": (sys.stdin, sys.stdout, sys.stderr),
        "recursion and switching": (sys.getrecursionlimit(), sys.getswitchinterval()),
        "lock of tqdm": vars(tqdm.tqdm).get("_lock"),
        "open sockets": [to for to in map(target, os.listdir("/proc/self/fd")) if to.startswith("socket")],
    }

def target(number):
    try:
        return os.readlink(f"/proc/self/fd/{number}")
    except OSError:
        return ""

before = look()

def check(what):
    after = look()
    changed = [name for name in before if before[name] != after[name]]
    assert not changed, f"{what} changes {changed}: {[difference(before[c], after[c]) for c in changed]}"

def difference(one, other):
    if isinstance(one, dict):
        return {n: (one.get(n), other.get(n)) for n in one | other if one.get(n, 0) != other.get(n, 0)}
    return one, other
"""
AXES = "{'com_height': (1.3, 1.4), 'com_speed': (1, 1.1)}"
USES = {
    "import": "import tdmf_slip; [getattr(tdmf_slip, name) for name in tdmf_slip.__all__]",
    "Runner": "runner = tdmf_slip.Runner('human')",
    "find_gait": "gait = tdmf_slip.find_gait()",
    "find_gait with a target": "tdmf_slip.find_gait(target={'speed': 1.0}, vary=['torque'], progress=True)",
    "a gait that is not found": """
try:
    tdmf_slip.find_gait(friction=0.02, touchdown_angle=1.0)
except tdmf_slip.TdmfSlipError:
    pass""",
    "sweep": "tdmf_slip.sweep(None, {'friction': [0.5, 0.6]})",
    "a grid": "tdmf_slip.sweep(None, {'friction': [0.5, 0.6], 'damping': [0.2, 0.21]})",
    "continue_branch": "tdmf_slip.continue_branch(None, {'friction': (0.6, 0.55)}, switch=False)",
    "stride_map": "tdmf_slip.stride_map(None, gait.apex, strides=3, law=lambda at, *number: {'torque': 0.2})",
    "basin": f"tdmf_slip.basin(None, {AXES}, n=2, progress=True)",
    "strides_to_fall": "tdmf_slip.strides_to_fall({}, 0.05, 20, max_strides=5, progress=True)",
    "lqr": "tdmf_slip.lqr(gait, ['torque'])",
    "optimize": "tdmf_slip.optimize(None, vary={'torque': (0.15, 0.25)}, minimize='cost_of_transport')",
    "simulate": "run = tdmf_slip.simulate(strides=1)",
    "inputs": "tdmf_slip.simulate(inputs={'hip.external_torque': ([0, 9], [0.0, 0.01])}, stop_time=9)",
    "simulate_many": "tdmf_slip.simulate_many([{}, {}], strides=1)",
    "plot": "gait.plot(); tdmf_slip.plot(run)",
    "a file": "run.to_netcdf('run.nc')",
}


@pytest.mark.skipif(sys.platform != "linux", reason="open sockets are read from /proc")
def test_the_process_stays_as_it_was(tmp_path):
    """Signal handlers, FMPy, Matplotlib, NumPy, locale, environment, threads and the like."""
    steps = [f"{use}\ncheck({what!r})" for what, use in USES.items()]
    program = "\n".join([LOOK, *steps, "print('unchanged')"])
    done = run_python("-c", program, cwd=tmp_path)
    assert done.stdout.splitlines()[-1:] == ["unchanged"], done.stderr


CHANGES = {
    "signal handlers": "signal.signal(signal.SIGINT, signal.SIG_IGN)",
    "FMPy": "fmpy.simulation.Input.apply = None",
    "rcParams": "matplotlib.rcParams['lines.linewidth'] = 9",
    "NumPy's error state": "numpy.seterr(all='ignore')",
    "environment": "os.environ['TDMF'] = '1'",
    "threads": "threading.Thread(target=threading.Event().wait, daemon=True).start()",
    "open sockets": "import socket; kept = socket.socket()",
}


@pytest.mark.skipif(sys.platform != "linux", reason="open sockets are read from /proc")
def test_the_look_at_the_process_sees_every_change():
    changes = "\n".join(CHANGES.values())
    program = f"{LOOK}\n{changes}\nafter = look()\nprint([c for c in before if before[c] != after[c]])"
    done = run_python("-c", program)
    assert done.stdout == f"{list(CHANGES)}\n", done.stderr
