"""Tools in Java: FMI4j imports the unit, VDMCheck checks it; scripts/test --release fetches both."""

import json
import shutil
import subprocess

import pytest
from conftest import HANGS, ROOT, unit_reference

JARS = ROOT / "build/importers/java"
QUANTITIES = ("period", "length", "speed", "work", "cost_of_transport")
REFERENCE = unit_reference()

pytestmark = pytest.mark.skipif(
    shutil.which("java") is None or not (JARS / "vdmcheck2.jar").is_file(),
    reason="NOT TESTED: FMI4j and VDMCheck are missing; ./scripts/test --release fetches them",
)


def java(*arguments):
    command = ["java", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=HANGS)


def test_fmi4j_runs_ten_strides(fmu_file, description):
    references = {variable.name: variable.valueReference for variable in description.modelVariables}
    wanted = [references[f"stride.{name}"] for name in QUANTITIES]
    program = ROOT / "tests/importers/TenStrides.java"
    done = java("-cp", f"{JARS}/*", program, fmu_file, references["stride.count"], *wanted)
    results = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
    assert results, done.stdout[-2000:] + done.stderr[-2000:]
    count, *values = json.loads(results[0].removeprefix("RESULT "))
    assert count == 10
    assert values == pytest.approx([REFERENCE[name] for name in QUANTITIES], rel=1e-8)


def test_vdmcheck_finds_no_fault(fmu_file):
    done = java("-jar", JARS / "vdmcheck2.jar", fmu_file)
    assert "No errors found." in done.stdout, done.stdout[-2000:] + done.stderr[-2000:]
