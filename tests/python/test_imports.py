"""Commands and analyses load only the packages that they use."""

import sys

import pytest
from conftest import run_python
from test_host import USES

RUN_THE_UNIT = {"import", "simulate", "inputs", "simulate_many", "plot", "a file"}
"""Uses in test_host that load FMPy."""
HEAVY = {"dask", "distributed", "matplotlib", "netCDF4", "pandas", "scipy", "xarray", "numba", "heyoka"}
SLOW = {"tqdm", "cffi", "pycparser"}
"""Packages that a short command must not load; the C declarations are parsed when the library is built."""
PROGRAM = """
import sys
sys.argv[0] = "tdmf-slip"
from tdmf_slip.__main__ import main
status = main()
print(status, *sys.modules)
import tdmf_slip
print(tdmf_slip.load_fmu()._folder is not None)
"""


def modules_after(*arguments):
    """Modules loaded once a command is done, and True if the unit was unpacked for it."""
    done = run_python("-c", PROGRAM, *arguments)
    printed, unpacked = done.stdout.splitlines()[-2:]
    status, *modules = printed.split()
    assert status == "0", done.stderr
    return set(modules), unpacked == "True"


def test_a_gait_loads_what_it_needs():
    modules, unpacked = modules_after("gait", "--friction", "0.6", "--json")
    assert {"tdmf_slip.cli.gait", "tdmf_slip.library.gait"} <= modules
    assert modules & (HEAVY | SLOW) == set()
    assert not any(name.split(".")[0] == "fmpy" for name in modules)
    parts = {name.split(".")[1] for name in modules if name.startswith("tdmf_slip.")}
    assert not parts & {
        "building",
        "feedback",
        "fitting",
        "fmu",
        "optimization",
        "paper",
        "pictures",
        "proof",
    }
    assert not unpacked


@pytest.mark.parametrize(
    ("arguments", "loaded"),
    [
        (("simulate", "--stop-time", "1"), {"fmpy.sundials.cvode"}),
        (("basin", "--n", "2", "--samples", "0", "--output", "map.nc"), {"xarray", "netCDF4"}),
    ],
)
def test_other_commands_load_what_they_need(arguments, loaded, tmp_path, monkeypatch):
    """Seen by the same look, which sees what there is."""
    monkeypatch.chdir(tmp_path)
    modules, unpacked = modules_after(*arguments)
    assert loaded <= modules and unpacked == (arguments[0] == "simulate")
    assert modules & {"xarray", "netCDF4"} <= loaded
    assert modules & {"matplotlib", "distributed", "numba", "heyoka"} == set()


RUN_ANALYSES = """
import os, sys
import matplotlib.pyplot, scipy.optimize, scipy.stats, xarray
import tdmf_slip
from tdmf_slip.fitting.measurements import Measured, Measurements

FITTED = Measurements(({'speed': Measured(1.0, 0.01)},), 'one')
ANALYSES |= {
    'compare': "tdmf_slip.compare([{'friction': 0.5}, {}], hold=['speed'], vary=['torque'])",
    'fit': "tdmf_slip.fit(None, FITTED, ['torque'])",
}
for name, analysis in ANALYSES.items():
    if not os.fork():
        gait = tdmf_slip.find_gait()
        exec(analysis)
        print(name, *sorted({name.split('.')[0] for name in sys.modules}), sep='\\t', flush=True)
        os._exit(0)
    os.wait()
"""
"""Runs each analysis in a fork of its own."""


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")
def test_no_analysis_loads_fmpy():
    """FMPy is for running the unit: nothing else waits for it, or is changed by it."""
    analyses = {name: use for name, use in USES.items() if name not in RUN_THE_UNIT}
    program = f"ANALYSES = {analyses}\n{RUN_ANALYSES}"
    done = run_python("-c", program)
    loaded = {
        name: set(modules) for name, *modules in (line.split("\t") for line in done.stdout.splitlines())
    }
    assert loaded.keys() > analyses.keys() and {"compare", "fit"} <= loaded.keys(), done.stderr
    assert [name for name, modules in loaded.items() if "fmpy" in modules] == []
    assert all("numpy" in modules for modules in loaded.values())
