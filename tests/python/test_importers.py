"""Other importers: each runs the default unit in Co-Simulation for ten strides and sees the reference gait.

The tools are the optional dependency `importers`, or `scripts/test --release` fetches them; one that is not
there is skipped. Each runs in a process of its own, because they bring native libraries, and some print what
they like.
"""

import csv
import json
import shutil
import sys

import fmpy
import own_pages
import pytest
import tdmf_slip
from conftest import QUANTITIES, ROOT, run, succeed, unit_reference

REFERENCE = unit_reference()
VALUES = [REFERENCE[name] for name in QUANTITIES]

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


def result_of(*command):
    """Report of a program: the number of strides, and the quantities of the last one."""
    done = run(*command)
    lines = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
    assert lines, done.stdout[-2000:] + done.stderr[-2000:]
    return json.loads(lines[-1].removeprefix("RESULT "))


def run_importer(program, unit, description):
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    names = [f"stride.{name}" for name in QUANTITIES]
    source = PROGRAM.format(program=program)
    return result_of(sys.executable, "-c", source, unit, json.dumps(references), json.dumps(names))


PROGRAMS = {"libcosimpy": LIBCOSIM, "ecospy": ECOS, "fmu_manipulation_toolbox": CONTAINER}


@pytest.fixture(params=[False, True], ids=["the unit", "a unit of one's own"])
def runner(request, fmu_file):
    """A unit, and the number of strides in 251 s with the quantities of the last one."""
    if not request.param:
        return fmu_file, [10, *VALUES]
    model = own_pages.my_runner()
    end = tdmf_slip.trajectory(model, times=[251.0]).isel(time=0)
    assert end["stride.count"] >= 8
    return model.unit, [float(end[f"stride.{name}"]) for name in ("count", *QUANTITIES)]


@pytest.mark.parametrize("module", PROGRAMS)
def test_strides_are_those_of_the_reference_and_of_the_engine(runner, tmp_path, module):
    pytest.importorskip(module, exc_type=ImportError)
    file, wanted = runner
    unit = shutil.copy(file, tmp_path)
    found = run_importer(PROGRAMS[module], unit, fmpy.read_model_description(unit))
    assert found == pytest.approx(wanted, rel=1e-8)


def test_toolbox_finds_no_fault(fmu_file):
    """`fmutool -check`, the second static checker beside FMPy's."""
    tool = shutil.which("fmutool", path=str(sys.prefix) + "/bin")
    if tool is None:
        pytest.skip("fmu-manipulation-toolbox is not installed")
    done = run(tool, "-input", fmu_file, "-check")
    said = done.stdout + done.stderr
    assert "compliant with FMI-2.0" in said and "No semantic error" in said, said


# ---- in Java: FMI4j imports the unit, VDMCheck checks it


JARS = ROOT / "build/importers/java"
in_java = pytest.mark.skipif(
    shutil.which("java") is None or not (JARS / "vdmcheck2.jar").is_file(),
    reason="NOT TESTED: FMI4j and VDMCheck are missing; ./scripts/test --release fetches them",
)


@in_java
def test_fmi4j_runs_ten_strides(fmu_file, description):
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    wanted = [references[f"stride.{name}"] for name in QUANTITIES]
    program = ROOT / "tests/importers/TenStrides.java"
    count, *values = result_of(
        "java", "-cp", f"{JARS}/*", program, fmu_file, references["stride.count"], *wanted
    )
    assert count == 10
    assert values == pytest.approx(VALUES, rel=1e-8)


@in_java
def test_vdmcheck_finds_no_fault(fmu_file):
    done = run("java", "-jar", JARS / "vdmcheck2.jar", fmu_file)
    assert "No errors found." in done.stdout, done.stdout[-2000:] + done.stderr[-2000:]


# ---- in Rust: fmi-sim runs the FMI 3.0 unit


FMI_SIM = ROOT / "build/importers/bin/fmi-sim"
in_rust = pytest.mark.skipif(
    not FMI_SIM.is_file(), reason="NOT TESTED: fmi-sim is missing; ./scripts/test --release builds it"
)


def rows_of(folder, fmi, interface, stop_time, *options, unit=None):
    output = folder / f"fmi{fmi}.csv"
    unit = unit or tdmf_slip.fmu_path(fmi)
    command = [FMI_SIM, "--quiet", "--model", unit, "--output-file", output, interface]
    succeed(*command, "-f", stop_time, *options)
    with output.open(newline="") as file:
        return list(csv.DictReader(file))


@in_rust
@pytest.mark.parametrize(
    "options",
    [(), ("--event-mode-used",), ("--event-mode-used", "--early-return-allowed")],
    ids=["plain", "event mode", "early return"],
)
def test_fmi_sim_in_co_simulation(tmp_path, options):
    rows = rows_of(tmp_path, 3, "co-simulation", 251.0, *options)
    last = rows[-1]
    assert last["stride.count"] == "10" and last["stride.word"] == REFERENCE["word"]
    for name in QUANTITIES:
        assert float(last[f"stride.{name}"]) == pytest.approx(REFERENCE[name], rel=1e-8), name
    # Early return adds a row for each event.
    assert (len(rows) > 2550) == ("--early-return-allowed" in options)


@in_rust
def test_fmi_sim_runs_a_unit_of_one_s_own(tmp_path):
    model = own_pages.my_runner()
    unit = model.unit.with_name("MyRunner_FMI3.fmu")
    last = rows_of(tmp_path, 3, "co-simulation", 251.0, unit=unit)[-1]
    end = tdmf_slip.trajectory(model, times=[251.0]).isel(time=0)
    assert int(last["stride.count"]) == end["stride.count"] >= 8
    for name in QUANTITIES:
        assert float(last[f"stride.{name}"]) == pytest.approx(float(end[f"stride.{name}"]), rel=1e-8), name
    rows = rows_of(tmp_path, 3, "model-exchange", 25.0, "--output-interval", "0.001", unit=unit)
    at = tdmf_slip.trajectory(model, times=[float(rows[-1]["time"])]).isel(time=0)
    assert float(rows[-1]["com.x"]) == pytest.approx(float(at["com.x"]), rel=5e-3)


@in_rust
def test_fmi_sim_in_model_exchange(tmp_path):
    """fmi-sim has only forward Euler, good to some thousandths. Both versions give the same rows."""
    two, three = (
        rows_of(tmp_path, fmi, "model-exchange", 25.1, "--output-interval", "0.001") for fmi in (2, 3)
    )
    assert three[-1]["stride.count"] == "1" and three[-1]["stride.word"] == REFERENCE["word"]
    for name in QUANTITIES:
        assert float(three[-1][f"stride.{name}"]) == pytest.approx(REFERENCE[name], rel=5e-3), name
    assert [row["foot.x"] for row in two] == [row["foot.x"] for row in three]
