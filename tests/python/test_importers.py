"""Other importers: each runs the default unit in Co-Simulation for ten strides and sees the reference gait.

The tools are the optional dependency `importers`; one that is not installed is skipped. Each runs in a
process of its own, because they bring native libraries, and some print what they like.
"""

import json
import shutil
import subprocess
import sys

import fmpy
import pytest
import tdmf_slip
from conftest import HANGS, QUANTITIES, unit_reference
from own_pages import loaded

REFERENCE = unit_reference()

# The programs get the unit's path and the value references of the quantities and of stride.count.
LIBCOSIM = """
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

execution = CosimExecution.from_step_size(step_size=10**8)
slave = execution.add_local_slave(CosimLocalSlave(fmu_path=unit, instance_name="runner"))
observer = CosimObserver.create_last_value()
execution.add_observer(observer)
execution.simulate_until(251 * 10**9)
values = observer.last_real_values(slave_index=slave, variable_references=[references[n] for n in names])
(count,) = observer.last_integer_values(slave_index=slave, variable_references=[references["stride.count"]])
"""

ECOS = """
from ecospy import EcosSimulation, EcosSimulationStructure

structure = EcosSimulationStructure()
structure.add_model("runner", unit)
with EcosSimulation(structure=structure, step_size=0.1) as simulation:
    simulation.init()
    simulation.step(2510)
    values = [simulation.get_real(f"runner::{name}") for name in names]
    count = simulation.get_integer("runner::stride.count")
"""

CONTAINER = """
import pathlib, subprocess
import fmpy

folder = pathlib.Path(unit).parent
tool = pathlib.Path(sys.executable).with_name("fmucontainer")
plan = {"name": "box.fmu", "step_size": 0.1, "fmu": [pathlib.Path(unit).name]}
(folder / "box.json").write_text(json.dumps(plan))
command = [tool, "-fmu-directory", folder, "-container", "box.json"]
subprocess.run(command, check=True, cwd=folder, capture_output=True)
wanted = [*names, "stride.count"]
rows = fmpy.simulate_fmu(str(folder / "box.fmu"), stop_time=251, output_interval=0.1, output=wanted)
values = [float(rows[name][-1]) for name in names]
count = int(rows["stride.count"][-1])
"""

PROGRAM = """
import json, sys
unit, references, names = sys.argv[1], json.loads(sys.argv[2]), json.loads(sys.argv[3])
{program}
print("RESULT " + json.dumps([count, *values]), flush=True)
"""


def run(program, unit, description):
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    names = [f"stride.{name}" for name in QUANTITIES]
    source = PROGRAM.format(program=program)
    command = [sys.executable, "-c", source, str(unit), json.dumps(references), json.dumps(names)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=HANGS)
    lines = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
    assert lines, done.stdout[-2000:] + done.stderr[-2000:]
    return json.loads(lines[-1].removeprefix("RESULT "))


@pytest.mark.parametrize(
    ("module", "program"),
    [("libcosimpy", LIBCOSIM), ("ecospy", ECOS), ("fmu_manipulation_toolbox", CONTAINER)],
    ids=["libcosimpy", "ecospy", "fmu-manipulation-toolbox"],
)
def test_ten_strides(fmu_file, description, tmp_path, module, program):
    pytest.importorskip(module, exc_type=ImportError)
    unit = shutil.copy(fmu_file, tmp_path / "TDMF_SLIP.fmu")
    count, *values = run(program, unit, description)
    assert count == 10
    assert values == pytest.approx([REFERENCE[name] for name in QUANTITIES], rel=1e-8)


@pytest.mark.parametrize("module", ["libcosimpy", "ecospy"])
def test_a_unit_of_one_s_own_gives_what_the_engine_gives(tmp_path, module):
    pytest.importorskip(module, exc_type=ImportError)
    model = loaded(tdmf_slip.new(tmp_path / "my_runner") / "page.py", unit=True)
    unit = shutil.copy(model.unit, tmp_path / "MyRunner.fmu")
    program = {"libcosimpy": LIBCOSIM, "ecospy": ECOS}[module]
    count, *values = run(program, unit, fmpy.read_model_description(unit))
    end = tdmf_slip.trajectory(model, times=[251.0]).isel(time=0)
    assert count == end["stride.count"] >= 8
    assert values == pytest.approx([float(end[f"stride.{name}"]) for name in QUANTITIES], rel=1e-8)


def test_toolbox_finds_no_fault(fmu_file):
    """`fmutool -check`, the second static checker beside FMPy's."""
    tool = shutil.which("fmutool", path=str(sys.prefix) + "/bin")
    if tool is None:
        pytest.skip("fmu-manipulation-toolbox is not installed")
    done = subprocess.run([tool, "-input", fmu_file, "-check"], capture_output=True, text=True, timeout=HANGS)
    said = done.stdout + done.stderr
    assert "compliant with FMI-2.0" in said and "No semantic error" in said, said
