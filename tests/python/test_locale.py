"""The unit in a program whose locale writes numbers with a decimal comma."""

import json
import os
import shutil

import pytest
from conftest import run_python, succeed

PROGRAM = """
import json, locale, sys
import fmpy, fmpy.simulation
import tdmf_slip
from tdmf_slip.fmu.simulation import run_unit

if sys.argv[1] != "C":
    locale.setlocale(locale.LC_ALL, sys.argv[1])
    assert locale.localeconv()["decimal_point"] == ","
rows = []
for interface in ("me", "cs"):
    run = run_unit(strides=10, interface=interface)
    numbers = [float(value).hex() for value in run.stride.values() if not isinstance(value, str)]
    rows.append([run.stride["word"], *numbers])
try:
    run_unit({"leg.length": 0.01})
except tdmf_slip.TdmfSlipError as problem:
    rows.append(str(problem))
said = []
folder = fmpy.extract(str(tdmf_slip.fmu_path()))
description = fmpy.read_model_description(folder)
unit = fmpy.simulation.instantiate_fmu(
    folder, description, "CoSimulation", debug_logging=True, logger=lambda *a: said.append(a[-1].decode())
)
unit.setupExperiment(stopTime=12.2)
unit.enterInitializationMode()
unit.exitInitializationMode()
unit.doStep(0.0, 12.2)
try:
    unit.doStep(12.2, 1.0)
except fmpy.fmi1.FMICallException:
    rows.append(said)
unit.freeInstance()
print(json.dumps(rows))
"""


def run(locale, **environment):
    done = run_python("-c", PROGRAM, locale, env=os.environ | environment)
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout.splitlines()[-1])


def test_ten_strides_are_the_same_to_the_last_bit(tmp_path):
    if shutil.which("localedef") is None or not os.path.isfile("/usr/share/i18n/locales/de_DE"):
        pytest.skip("NOT TESTED: no sources of locales; Debian's package is called locales")
    target = tmp_path / "de_DE.UTF-8"
    succeed("localedef", "-i", "de_DE", "-f", "UTF-8", target)
    with_comma = run("de_DE.UTF-8", LOCPATH=str(tmp_path))
    assert with_comma == run("C")
    refusal, (event, stop) = with_comma[-2:]
    assert "0.01" in refusal
    assert event.startswith("touchdown at 12.02")
    assert "stop time, 12.2 s" in stop
